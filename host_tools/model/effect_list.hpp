#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::model {

/// Effects proposed for a first fit of a gyro, in the syntax of parse_effects().
inline constexpr const char* kFirstEffects = "bias,bias_temperature:order=2,temperature_rate";

/// `bias,bias_temperature:order=3,thermal_hysteresis:radius2=?[5,20]` -> terms without
/// coefficients. A given shape parameter is kept. Any other starts at its default and is
/// identified, unless it is a whole number or its description keeps it or disables its part of the
/// effect; `=?` identifies it in any case, `=?[min,max]` within these bounds. An event without a
/// time is to be searched for. Throws InputError for unknown effects, unknown parameters and values
/// out of bounds.
std::vector<EffectTerm> parse_effects(const std::string& list);

/// Possible extensions of a term: the next order, an optional part to be identified; empty if it
/// has neither. Its other parameters are identified or not as before.
std::vector<EffectTerm> grown_terms(const EffectTerm& own);

/// Settings that identify what makes a term's formula exact and is not identified: a further part
/// that is left out or has a given shape, a parameter that is kept at its default or given, two
/// orders more (an even and an odd one): {"period2=?", "chirp=?"}. Empty if it has nothing of the
/// kind.
std::vector<std::string> possible_refinements(const EffectTerm& own);

/// `name`, with the first number from 2 on behind it (name_2) by which it differs from all terms'.
std::string free_name(const std::vector<EffectTerm>& terms, const std::string& name);

/// Adds the term `NAME = EXPRESSION`. Throws InputError like expression_term(), and for a name
/// already in use.
void add_expression(std::vector<EffectTerm>& terms, const std::string& definition);

}  // namespace fogcomp::model
