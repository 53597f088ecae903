#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::model {

/// What a first fit of a gyro is proposed to have, as for parse_effects().
inline constexpr const char* kFirstEffects = "bias,bias_temperature:order=2,temperature_rate";

/// `bias,bias_temperature:order=3,thermal_hysteresis:radius2=?[5,20]` -> terms without
/// coefficients. A shape parameter that is given stays as given. Another starts at its default and
/// is identified, unless it is a whole number or its description keeps it or leaves its part of the
/// effect out; `=?` identifies it all the same, `=?[min,max]` within these bounds. An event
/// without a time is to be searched for. Throws InputError for unknown effects, unknown parameters
/// and values out of bounds.
std::vector<EffectTerm> parse_effects(const std::string& list);

/// What a term could grow to: the next order, an optional part to be identified; none where it has
/// neither. Its other parameters are to be identified or not as before.
std::vector<EffectTerm> grown_terms(const EffectTerm& own);

/// Adds the term `NAME = EXPRESSION`. Throws InputError as expression_term() does, and for a name
/// that one of the terms has.
void add_expression(std::vector<EffectTerm>& terms, const std::string& definition);

}  // namespace fogcomp::model
