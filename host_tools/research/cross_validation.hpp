#pragma once

#include <Eigen/Core>
#include <functional>

namespace fogcomp::research {

/// Predicts `test` rows after a fit to `train` rows (inputs, target; inputs).
using FitAndPredict = std::function<Eigen::VectorXd(
    const Eigen::MatrixXd& train, const Eigen::VectorXd& target, const Eigen::MatrixXd& test)>;

/// Root mean square of what is predicted for rows that were left out: ten folds, each of every
/// tenth stretch of neighbouring rows (100 stretches), because single rows share their neighbours'
/// noise and history.
double cross_validated_rms(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
                           const FitAndPredict& method);

}  // namespace fogcomp::research
