#pragma once

#include <vector>

#include "diagnosis/candidates.hpp"

namespace fogcomp::diagnosis {

/// Shapes of an event: steps at evenly spaced times of each recording at which they are visible.
std::vector<Candidate::Shape> step_shapes(const series::Rows& rows,
                                          const ProjectOutModel& project_out_model,
                                          const model::EffectTerm& step);

/// Moves each of the best few steps to the nearby row at which it explains most.
void move_steps(const series::Rows& rows, const ProjectOutModel& project_out_model,
                std::vector<Candidate::Shape>& shapes, const Eigen::VectorXd& residual);

}  // namespace fogcomp::diagnosis
