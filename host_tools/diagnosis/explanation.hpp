#pragma once

#include <array>
#include <vector>

#include "diagnosis/hypotheses.hpp"

namespace fogcomp {

/// Of the excess, by one, two, three effects: what leaves more than that does not explain it.
/// Several effects together imitate a good deal of what is none of them.
constexpr std::array<double, 3> kMostUnexplained{0.1, 0.06, 0.05};

/// The same by three that temperature and time alone drive, of which nearly every function of these
/// can be made: of 156 gyros with an effect outside the catalogue, visible as 0.7 of the noise, six
/// were explained so within 0.05; of 166 with three catalogued effects three leave more than this.
/// Not where an effect leads whose shape is fixed: that is not bent into an imitation.
constexpr double kMostUnexplainedByThreePliable = 0.025;

/// The same by an event, whose form is exact where a physical effect's is not: a maximum that is
/// kept, or a load that is slow to settle, is like a step in all but a few hundredths.
constexpr double kMostUnexplainedByEvent = 0.03;

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
Explanation explain(const ExplainedSpace& space, const Library& library,
                    const ColumnRange& structure, const std::vector<Hypothesis>& hypotheses);

}  // namespace fogcomp
