#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/signal/inputs.hpp"
#include "simulation/chamber.hpp"
#include "simulation/coil/coil_error.hpp"
#include "simulation/parameters.hpp"
#include "simulation/thermal/gyro_thermal_model.hpp"

namespace fogcomp::simulation {

/// Where what depends on temperature has its value at room temperature.
constexpr double kReference_degc = 20;

/// Slow surroundings of the gyro that effects act through and that may be recorded: the true
/// values behind the extension inputs, in their units. That of a second temperature is what its
/// sensor says.
class Ambient {
 public:
  double& operator[](fog::Input input) { return values_[extension_number(input)]; }
  double operator[](fog::Input input) const { return values_[extension_number(input)]; }

 private:
  std::array<double, fog::kExtensionInputs> values_{};
};

/// Everything that an effect can depend on, at the end of one thermal step.
struct GyroState {
  double time_s = 0;
  double step_s = 0;
  bool powered = true;
  const ChamberState* chamber = nullptr;
  const GyroThermalModel* thermal = nullptr;
  Ambient ambient;
  double input_rate_dph = 0;
  /// Input rate and the effects that come before in the catalogue: what the closed loop sees.
  double loop_rate_dph = 0;
};

/// One contribution to the gyro's rate.
class Effect {
 public:
  virtual ~Effect() = default;
  /// Called once for every thermal step, in order, the first time for the state at time 0.
  /// Returns the contribution in deg/h.
  virtual double step(const GyroState& state) = 0;
};

/// What an effect may be built from, beside its parameters.
struct EffectContext {
  const CoilError& coil_error;
  double duration_s;  ///< of the programme
  std::uint64_t seed;
};

/// An entry of the simulator's catalogue. Names are the contract's effect names, plus some that
/// only the simulator has.
struct EffectDescription {
  std::string name;
  std::string summary;  ///< one line: the physics, and the source of its size
  std::vector<ParameterSpec> parameters;
  std::unique_ptr<Effect> (*make)(const Parameters& parameters, const EffectContext& context);
  /// What the effect adds to the gyro's heat flow; nullptr: nothing.
  void (*add_to_design)(const Parameters& parameters, GyroThermalDesign& design) = nullptr;
};

/// In the order in which they act: the ones that depend on the rate come last.
const std::vector<EffectDescription>& effect_catalogue();

/// `peak` replaces the natural size: the effect is scaled so that its largest magnitude over this
/// programme is as given. 0 leaves the natural size.
ParameterSpec peak_parameter();
/// `scale` multiplies the natural size: the same gyro on every programme, which `peak` is not.
ParameterSpec scale_parameter();

/// The `make` of a class constructed from (const Parameters&, const EffectContext&).
template <class Kind>
std::unique_ptr<Effect> make_effect(const Parameters& parameters, const EffectContext& context) {
  return std::make_unique<Kind>(parameters, context);
}

}  // namespace fogcomp::simulation
