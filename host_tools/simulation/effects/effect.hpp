#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/signal/inputs.hpp"
#include "simulation/chamber.hpp"
#include "simulation/coil.hpp"
#include "simulation/parameters.hpp"
#include "simulation/thermal/gyro_thermal_model.hpp"

namespace fogcomp::simulation {

/// Factor by which a thermally activated process is faster at `degc` than at 20 degC.
/// `activation_ev`: activation energy, eV.
inline double arrhenius(double activation_ev, double degc) {
  constexpr double kBoltzmannEv = 8.617333262e-5;
  constexpr double kZeroDegcInKelvin = 273.15;
  constexpr double kReferenceK = 293.15;
  return std::exp(activation_ev / kBoltzmannEv *
                  (1 / kReferenceK - 1 / (degc + kZeroDegcInKelvin)));
}

/// Temperature at which temperature-dependent parameters have their stated values.
constexpr double kReference_degc = 20;

/// Slow ambient quantities that effects depend on and that may be recorded: true values of the
/// extension inputs, in their units. For a second temperature, the reading of its sensor.
class Ambient {
 public:
  double& operator[](fog::Input input) { return values_[extension_number(input)]; }
  double operator[](fog::Input input) const { return values_[extension_number(input)]; }

 private:
  std::array<double, fog::kExtensionInputs> values_{};
};

/// Everything that an effect can depend on, at the end of a thermal step.
struct GyroState {
  double time_s = 0;
  double step_s = 0;
  bool powered = true;
  const ChamberState* chamber = nullptr;
  const GyroThermalModel* thermal = nullptr;
  Ambient ambient;
  double input_rate_dph = 0;
  /// Input rate plus the preceding effects in the catalogue: the rate of the closed loop.
  double loop_rate_dph = 0;
};

/// One contribution to the gyro's rate.
class Effect {
 public:
  virtual ~Effect() = default;
  /// To be called once per thermal step, in order, first for the state at time 0. Returns the
  /// contribution in deg/h.
  virtual double step(const GyroState& state) = 0;
};

/// Data for constructing an effect, beside its parameters.
struct EffectContext {
  const CoilError& coil_error;
  double duration_s;  ///< of the programme
  std::uint64_t seed;
};

/// An entry of the simulator's catalogue: the effects of the drift model's catalogue, plus some
/// that only the simulator has.
struct EffectDescription {
  std::string name;
  std::string summary;  ///< one line: physics, and source of its size
  std::vector<ParameterSpec> parameters;
  std::unique_ptr<Effect> (*make)(const Parameters& parameters, const EffectContext& context);
  /// Adds parts of the effect to the gyro's thermal design; nullptr: none.
  void (*add_to_design)(const Parameters& parameters, GyroThermalDesign& design) = nullptr;
};

/// In the order of evaluation: effects that depend on the rate come last.
const std::vector<EffectDescription>& effect_catalogue();

/// `peak` scales the effect so that its largest magnitude over this programme is as given. 0:
/// natural size.
ParameterSpec peak_parameter();
/// `scale` multiplies the natural size: the same gyro in every programme, unlike `peak`.
ParameterSpec scale_parameter();

/// The `make` of a class constructed from (const Parameters&, const EffectContext&).
template <class Kind>
std::unique_ptr<Effect> make_effect(const Parameters& parameters, const EffectContext& context) {
  return std::make_unique<Kind>(parameters, context);
}

}  // namespace fogcomp::simulation
