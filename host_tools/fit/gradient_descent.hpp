#pragma once

#include "fit/trainer.hpp"

namespace fogcomp::fit {

/// Gradient descent with momentum and adaptive learning rate, starting at `first`: rules and
/// constants of MATLAB's traingdx (fit/TRAINING.md).
TrainerResult descend(const TrainingProblem& problem, const TrainerSettings& settings,
                      const Eigen::VectorXd& first);

}  // namespace fogcomp::fit
