#pragma once

#include <vector>

#include "diagnosis/hypotheses.hpp"

namespace fogcomp::diagnosis {

/// The part of a residual that the best set of effects explains.
struct Explanation {
  const Hypothesis* best = nullptr;
  double excess = 0;       ///< chi^2 above noise that there is to explain
  double unexplained = 0;  ///< share of it
  bool enough = false;     ///< what is left is noise, or little of the whole
};

/// The smallest set of effects that explains enough; else the best one, which does not.
/// `structure`: smooth functions of all variables, which define what is to be explained.
/// `hypotheses`: of up to three parts, at least one; they must outlive the result.
Explanation explain(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                    const series::ColumnRange& structure,
                    const std::vector<Hypothesis>& hypotheses);

}  // namespace fogcomp::diagnosis
