#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/effects/effect.hpp"
#include "model/model.hpp"
#include "model/real_effect.hpp"

namespace fogcomp::model {

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

/// What can be said of a term, whether it is an effect of the catalogue or an expression.
struct TermInfo {
  struct Parameter {
    std::string name;
    std::string unit;    ///< "" where it has none
    ShapeBounds bounds;  ///< of the search; a 0 below them leaves its part of the effect out
    fog::Scale scale = fog::Scale::linear;  ///< of the search
    const char* at_least = nullptr;         ///< as fog::ParameterDescription has them
    const char* at_most = nullptr;
    bool is_reference = false;  ///< taken from the rows, never searched for
  };
  std::string title;
  std::string equation;
  std::vector<Parameter> parameters;
  std::vector<fog::CoefficientDescription> coefficients;  ///< as many as it can have
  fog::InputMask needs = 0;
  const char* host_only = nullptr;  ///< why the board cannot have it; nullptr where it can
  bool outlives_power = false;      ///< a board that is switched off loses its time
};
TermInfo info_of(const EffectTerm& term);

/// " degC" as it follows a number; "" where the parameter has no unit.
std::string unit_behind_number(const fog::ParameterDescription& parameter);

/// Whether what a coefficient stands for comes and goes with the temperature rate.
inline bool of_temperature_rate(const fog::CoefficientDescription& coefficient) {
  return coefficient.multiplies == fog::Multiplies::temperature_rate;
}

/// Whether a shape parameter in `unit` of an effect with these coefficients is a lag of the
/// temperature rate: in the model it stands behind the lags of the board's derivative.
bool is_lag_of_rate(const std::string& unit,
                    const std::vector<fog::CoefficientDescription>& coefficients);

/// A term with its shape, over blocks of `block_s`.
std::unique_ptr<RealEffect> make_effect(const EffectTerm& term, double block_s);

/// A term without a coefficient from `NAME = EXPRESSION`; its parameters are to be identified.
/// Throws InputError as parse_expression() does, and for the name of an effect.
EffectTerm expression_term(const std::string& definition);

/// What the effects and the network of a model need beside the coil's temperature.
fog::InputMask needs_of(const Model& model);

/// Whether a parameter is of an effect's second part, which 0 leaves out.
inline bool is_optional_part(const fog::ParameterDescription& parameter) {
  return parameter.not_given == fog::NotGiven::left_out;
}

/// Whether a parameter that is not given is taken from the rows of the fit.
inline bool is_reference(const fog::ParameterDescription& parameter) {
  return parameter.not_given == fog::NotGiven::mean_temperature ||
         parameter.not_given == fog::NotGiven::largest_input_rate;
}

/// Where parameter `index` is searched: that of an optional part where the one before it is.
ShapeBounds catalogue_bounds(const CatalogueEntry& entry, std::size_t index);

/// Whether a term is an event of a recording rather than a property of the gyro.
bool is_event(const EffectTerm& term);

/// Names of all effects.
std::vector<std::string> effect_names();

}  // namespace fogcomp::model
