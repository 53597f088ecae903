#pragma once

#include <vector>

#include "diagnosis/hypotheses.hpp"

namespace fogcomp::diagnosis {

/// What the best set of effects explains of a residual.
struct Explanation {
  const Hypothesis* best = nullptr;
  double excess = 0;       ///< chi^2 above noise that there is to explain
  double unexplained = 0;  ///< share of it
  bool enough = false;     ///< what is left is noise, or little of the whole
};

/// The smallest set of effects that explains enough; else the best one, which does not.
/// `structure`: smooth functions of everything, which show what there is. `hypotheses`: of up to
/// three parts, at least one; they must outlive the result.
Explanation explain(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                    const series::ColumnRange& structure,
                    const std::vector<Hypothesis>& hypotheses);

}  // namespace fogcomp::diagnosis
