#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/coil/coil_geometry.hpp"
#include "simulation/effects/effect.hpp"
#include "simulation/parameters.hpp"
#include "simulation/thermal/gyro_thermal_model.hpp"

namespace fogcomp::simulation {

/// A part of the gyro that is always there, as --list shows it.
struct PartDescription {
  std::string name;
  std::string summary;
  std::vector<ParameterSpec> parameters;
};

/// coil, housing, sensor, sensor2, noise.
const std::vector<PartDescription>& gyro_parts();

/// Which gyro to simulate: its parts, and the effects that are on, with all parameters.
class GyroDescription {
 public:
  /// No effects and no noise; parts as they are by default.
  GyroDescription();

  struct ActiveEffect {
    const EffectDescription* description;
    Parameters parameters;
  };

  /// Switches an effect on, or changes it or a part. `assignments` are name=value. Throws
  /// InputError `where: …` for an unknown name (naming the nearest) or a bad value.
  void set(const std::string& where, const std::string& name,
           const std::vector<std::string>& assignments);
  /// Switches an effect off; throws InputError where it is not on.
  void remove(const std::string& where, const std::string& name);

  /// In catalogue order, which is the order in which they act.
  const std::vector<ActiveEffect>& effects() const { return effects_; }
  const Parameters& part(const std::string& name) const;

  CoilGeometry coil() const;
  GyroThermalDesign thermal_design() const;

 private:
  std::vector<ActiveEffect> effects_;
  std::vector<Parameters> parts_;
};

/// Applies a preset to `gyro`: lines `NAME name=value …`, `#` starts a comment. Throws InputError
/// `file:LINE: …`.
void apply_preset(GyroDescription& gyro, const std::string& text, const std::string& file);

/// Applies `NAME`, `NAME:k=v,k=v` as the command line has it.
void apply_option(GyroDescription& gyro, const std::string& where, const std::string& option);

}  // namespace fogcomp::simulation
