#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/effects/effect.hpp"
#include "model/model.hpp"
#include "model/real_numbers.hpp"

namespace fogcomp {

/// An effect of the firmware's registry running in double, for identification.
class RealEffect {
 public:
  virtual ~RealEffect() = default;
  virtual std::size_t regressor_count() const = 0;
  virtual void reset(const fog::Signals<RealNumbers>& signals) = 0;
  /// Advances one block; writes regressor_count() values.
  virtual void step(const fog::Signals<RealNumbers>& signals, double* regressors) = 0;
};

/// What the host knows of an effect, read off its header in the core.
struct CatalogueEntry {
  fog::EffectDescription description;
  std::vector<fog::ParameterDescription> parameters;
  std::vector<fog::CoefficientDescription> coefficients;  ///< as many as it can have
  std::vector<int> constant_fractions;
  /// Board constants in double, for shape parameters and a block period in seconds.
  std::vector<double> (*constants)(const std::vector<double>& parameters, double block_s);
  std::unique_ptr<RealEffect> (*make)(const std::vector<double>& constants);
};

/// All effects, in the order of the registry.
const std::vector<CatalogueEntry>& catalogue();

/// Throws InputError for an unknown name, suggesting the nearest.
const CatalogueEntry& find_effect(const std::string& name);

/// What the effects and the network of a model need beside the coil's temperature.
fog::InputMask needs_of(const Model& model);

/// Where a parameter is searched. One that may be 0, which leaves its part of the effect out, is
/// searched from an eightieth of its most.
ShapeBounds catalogue_bounds(const fog::ParameterDescription& parameter);

/// The one effect that is an event of a recording rather than a property of the gyro.
inline constexpr const char* kBiasStep = "bias_step";
inline bool is_event(const EffectTerm& term) {
  return term.name == kBiasStep;
}

/// Names of all effects.
std::vector<std::string> effect_names();

}  // namespace fogcomp
