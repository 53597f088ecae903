#pragma once

#include "network/trainer.hpp"

namespace fogcomp::network {

/// Gradient descent with momentum and adaptive learning rate, starting at `first`: rules and
/// constants of MATLAB's traingdx (network/TRAINING.md).
TrainerResult descend(const TrainingProblem& problem, const TrainerSettings& settings,
                      const Eigen::VectorXd& first);

}  // namespace fogcomp::network
