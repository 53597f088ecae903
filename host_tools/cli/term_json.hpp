#pragma once

#include "model/model.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {

/// Sets members of an object: a term's shape parameters by name, its coefficients by symbol.
/// Natural units.
void set_parameters(Json& object, const EffectTerm& term);
void set_coefficients(Json& object, const EffectTerm& term);

}  // namespace fogcomp::cli
