#pragma once

#include <vector>

#include "diagnosis/candidates.hpp"

namespace fogcomp::diagnosis {

/// An event has a moment, not a shape: a step at evenly spaced times of each recording, where it
/// can be seen.
std::vector<Candidate::Shape> step_shapes(const series::Rows& rows,
                                          const ProjectOutModel& project_out_model,
                                          const model::EffectTerm& step);

/// Moves each of the best few steps to the row near it from which on it explains most.
void move_steps(const series::Rows& rows, const ProjectOutModel& project_out_model,
                std::vector<Candidate::Shape>& shapes, const Eigen::VectorXd& residual);

}  // namespace fogcomp::diagnosis
