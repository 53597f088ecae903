#pragma once

#include <functional>
#include <vector>

#include "fit/whitened_problem.hpp"
#include "model/shape_parameter.hpp"

namespace fogcomp::fit {

/// Moves the parameters to where the projected cost is smallest (Golub & Pereyra 1973): those of
/// `ranges` (one for each parameter) in turn over a bounded grid, the others following to first
/// order; then Gauss-Newton on all with the coefficients, from where they are and from the deepest
/// dips of that grid. `progress` is told how much is done, 0..1. Returns which parameters a dip
/// took elsewhere.
std::vector<bool> search_shapes(WhitenedProblem& problem,
                                const std::vector<model::ShapeParameter>& parameters,
                                const std::vector<bool>& ranges,
                                const std::function<void(double)>& progress = {});

}  // namespace fogcomp::fit
