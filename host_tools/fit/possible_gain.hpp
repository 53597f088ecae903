#pragma once

#include <vector>

#include "fit/foretelling.hpp"
#include "fit/known_regressors.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// How much chi^2 could fall if a fitted model's shapes were freed: to first order, on the rows of
/// the fit, so that a gain out of sample is hardly larger. A hundredth of the time of a fit and its
/// judgement. `before`: fitted terms. `after`: the same with further shapes marked to be identified
/// or with other starts.
double possible_gain(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                     const std::vector<model::EffectTerm>& after, const JudgedWith& with);

}  // namespace fogcomp::fit
