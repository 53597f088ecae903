#pragma once

#include <Eigen/Core>
#include <functional>

namespace fogcomp::research {

/// Predicts `test` rows after a fit to `train` rows (inputs, target; inputs).
using FitAndPredict = std::function<Eigen::VectorXd(
    const Eigen::MatrixXd& train, const Eigen::VectorXd& target, const Eigen::MatrixXd& test)>;

/// Rms error of predictions for rows that were left out: ten folds, each of every tenth stretch of
/// neighbouring rows (100 stretches), because single rows share noise and history with their
/// neighbours.
double cross_validated_rms(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
                           const FitAndPredict& method);

}  // namespace fogcomp::research
