#pragma once

#include <string>
#include <vector>

#include "simulation/coil.hpp"
#include "simulation/effects/effect.hpp"
#include "simulation/parameters.hpp"
#include "simulation/thermal/gyro_thermal_model.hpp"

namespace fogcomp::simulation {

/// A part of every gyro, for --list.
struct PartDescription {
  std::string name;
  std::string summary;
  std::vector<ParameterSpec> parameters;
};

/// coil, housing, sensor, sensor2, noise.
const std::vector<PartDescription>& gyro_parts();

/// The gyro to simulate: its parts and enabled effects, with all parameters.
class GyroDescription {
 public:
  /// No effects and no noise; parts with their defaults.
  GyroDescription();

  struct ActiveEffect {
    const EffectDescription* description;
    Parameters parameters;
  };

  /// Enables or changes an effect, or changes a part. `assignments` are name=value. Throws
  /// InputError `where: …` for an unknown name (with the nearest one) or a bad value.
  void set(const std::string& where, const std::string& name,
           const std::vector<std::string>& assignments);
  /// The same by a command-line option: `NAME` or `NAME:k=v,k=v`.
  void apply_option(const std::string& where, const std::string& option);
  /// The same by a preset: lines `NAME name=value …`; `#` starts a comment. Throws InputError
  /// `file:LINE: …`.
  void apply_preset(const std::string& text, const std::string& file);
  /// Disables an effect; throws InputError if it is not enabled.
  void remove(const std::string& where, const std::string& name);

  /// In catalogue order, which is the order of evaluation.
  const std::vector<ActiveEffect>& effects() const { return effects_; }
  const Parameters& part(const std::string& name) const;

  CoilGeometry coil() const;
  GyroThermalDesign thermal_design() const;

 private:
  std::vector<ActiveEffect> effects_;
  std::vector<Parameters> parts_;
};

}  // namespace fogcomp::simulation
