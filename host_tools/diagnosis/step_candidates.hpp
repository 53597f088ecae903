#pragma once

#include <vector>

#include "diagnosis/candidates.hpp"
#include "diagnosis/visible_part.hpp"

namespace fogcomp::diagnosis {

/// Shapes of an event: steps at evenly spaced times of each recording at which they are visible.
std::vector<Candidate::Shape> step_shapes(const series::Rows& rows,
                                          const ProjectOutModel& project_out_model,
                                          const model::EffectTerm& step);

/// Moves a few of the steps to the rows at which the residual jumps most. Of all rows those are
/// taken, at least half a grid interval apart, at which a step explains most of what the model and
/// the `smooth` functions (orthonormal, as visible_structure() makes them) leave: an effect that is
/// missing as well has no edges. A step that explains less than rules::kMinPlacedChi2Drop there, in
/// units of the mean square of what is left, is tested on the grid only, as noise is.
void place_steps(std::vector<Candidate::Shape>& shapes, const series::Rows& rows,
                 const Residualizer& residualizer, const Eigen::MatrixXd& smooth);

}  // namespace fogcomp::diagnosis
