#pragma once

#include <string>
#include <vector>

#include "identification/design.hpp"
#include "model/model.hpp"

namespace fogcomp {

/// `bias,bias_temperature:order=3,temperature_rate` -> terms with shape parameters, no
/// coefficients. Throws InputError for unknown effects, unknown parameters and values out of
/// bounds.
std::vector<EffectTerm> parse_effects(const std::string& list);

/// Identifies the coefficients of model.terms by linear least squares and sets the trained range.
/// Returns the residual, a value per row of `design`. Throws InputError for too few rows and for
/// effects that the recording cannot tell apart.
Eigen::VectorXd identify(Model& model, const Design& design);

}  // namespace fogcomp
