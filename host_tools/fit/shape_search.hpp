#pragma once

#include <functional>
#include <vector>

#include "fit/foretelling.hpp"
#include "fit/known_regressors.hpp"
#include "fit/whitened_problem.hpp"
#include "model/model.hpp"
#include "model/shape_parameter.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Minimises the projected cost (Golub & Pereyra 1973) over the parameters. Those of `ranges` (one
/// per parameter) are searched in turn over a bounded grid, the others following to first order;
/// then Gauss-Newton on all with the coefficients, from the present values and from the deepest
/// minima of that grid. `exact`: to a minimum within rounding, otherwise within a small part of the
/// parameters' standard deviations. `progress` is called with the fraction done, 0..1. Returns
/// which parameters moved to another minimum.
std::vector<bool> search_shapes(WhitenedProblem& problem,
                                const std::vector<model::ShapeParameter>& parameters,
                                const std::vector<bool>& ranges, bool exact = true,
                                const std::function<void(double)>& progress = {});

/// The smallest cost to first order: of all parameters around their present values, and of each of
/// `ranges` over the grid of search_shapes().
double first_order_cost(const WhitenedProblem& problem,
                        const std::vector<model::ShapeParameter>& parameters,
                        const std::vector<bool>& ranges);

/// How much chi^2 could fall if a fitted model's shapes were freed: to first order, on the rows of
/// the fit, so that a gain out of sample is hardly larger. A hundredth of the time of a fit and its
/// judgement. `before`: fitted terms. `after`: the same with further shapes marked to be identified
/// or with other starts.
double possible_gain(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                     const std::vector<model::EffectTerm>& after, const JudgedWith& with);

}  // namespace fogcomp::fit
