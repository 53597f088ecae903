#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/effects/effect.hpp"
#include "model/model.hpp"
#include "model/real_effect.hpp"

namespace fogcomp::model {

/// Host data of an effect, from its header in the core.
struct CatalogueEntry {
  fog::EffectDescription description;
  std::vector<fog::ParameterDescription> parameters;
  std::vector<fog::CoefficientDescription> coefficients;  ///< the largest possible number
  std::vector<int> constant_fractions;
  /// Board constants in double, from shape parameters and block period in seconds.
  std::vector<double> (*constants)(const std::vector<double>& parameters, double block_s);
  std::unique_ptr<RealEffect> (*make)(const std::vector<double>& constants);
};

/// All effects, in the order of the registry.
const std::vector<CatalogueEntry>& catalogue();

/// Throws InputError for an unknown name, suggesting the nearest.
const CatalogueEntry& find_effect(const std::string& name);

/// Properties of a term, an effect of the catalogue or an expression.
struct TermInfo {
  struct Parameter {
    std::string name;
    std::string unit;    ///< "" if it has none
    ShapeBounds bounds;  ///< of the search; 0 below the bounds disables this part of the effect
    fog::Scale scale = fog::Scale::linear;  ///< of the search
    const char* at_least = nullptr;         ///< as in fog::ParameterDescription
    const char* at_most = nullptr;
    fog::Time time = fog::Time::other;
    bool is_reference = false;  ///< computed from the rows, never searched for
  };
  std::string title;
  std::string equation;
  std::vector<Parameter> parameters;
  std::vector<fog::CoefficientDescription> coefficients;  ///< the largest possible number
  fog::InputMask needs = 0;
  const char* host_only = nullptr;  ///< why the board cannot run it; nullptr if it can
  bool outlives_power = false;      ///< depends on time while the power is off
};
TermInfo info_of(const EffectTerm& term);

/// " degC" to be printed after a number; "" if the parameter has no unit.
std::string unit_behind_number(const fog::ParameterDescription& parameter);

/// Whether a coefficient's regressor follows the temperature rate.
inline bool of_temperature_rate(const fog::CoefficientDescription& coefficient) {
  return coefficient.multiplies == fog::Multiplies::temperature_rate;
}

/// Creates a term with its shape, for blocks of `block_s`; it takes the signals of the block
/// before, as on the board.
std::unique_ptr<RealEffect> make_effect(const EffectTerm& term, double block_s);
/// The term for make_effect() that does the same with the signals of the present block.
EffectTerm for_present_block(EffectTerm term, double block_s);

/// A term without coefficient from `NAME = EXPRESSION`; its parameters are to be identified. Throws
/// InputError like parse_expression(), and for the name of an effect.
EffectTerm expression_term(const std::string& definition);

/// Inputs that effects and network of a model need beside the coil temperature.
fog::InputMask needs_of(const Model& model);

/// Whether a parameter belongs to an effect's second part, which 0 disables.
inline bool is_optional_part(const fog::ParameterDescription& parameter) {
  return parameter.not_given == fog::NotGiven::left_out;
}

/// Whether a parameter that is not given is computed from the rows of the fit.
inline bool is_reference(const fog::ParameterDescription& parameter) {
  return parameter.not_given == fog::NotGiven::mean_temperature ||
         parameter.not_given == fog::NotGiven::largest_input_rate;
}

/// Search bounds of parameter `index`; for an optional part those of the parameter before it.
ShapeBounds catalogue_bounds(const CatalogueEntry& entry, std::size_t index);

/// Whether a term is an event of a recording rather than a property of the gyro. Models of older
/// files have such terms, and a diagnosis names one; it is added as a cut of the recording.
bool is_event(const EffectTerm& term);

/// Throws InputError for an event among effects to be fitted.
void refuse_events(const std::vector<EffectTerm>& terms);

/// Removes the events of an older file, for a fit; returns a sentence on each.
std::vector<std::string> leave_out_events(std::vector<EffectTerm>& terms);

/// Names of all effects, and of the event.
std::vector<std::string> effect_names();

}  // namespace fogcomp::model
