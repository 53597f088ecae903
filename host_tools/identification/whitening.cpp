#include "identification/whitening.hpp"

#include <cmath>

namespace fogcomp {

Whitening::Whitening(const NoiseModel& noise, const Rows& rows, const Eigen::VectorXd& weights) {
  const auto components = static_cast<Eigen::Index>(noise.components.size());
  const Eigen::Index size = rows.size();
  decay_.setZero(components, size);
  gain_.setZero(components, size);
  scale_.resize(size);
  Eigen::VectorXd variances(components);
  for (Eigen::Index j = 0; j < components; ++j) {
    variances[j] = noise.components[static_cast<std::size_t>(j)].variance;
  }
  Eigen::MatrixXd covariance = variances.asDiagonal();
  std::size_t next_run = 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (next_run < rows.run_starts.size() && rows.run_starts[next_run] == row) {
      covariance = variances.asDiagonal();  // decay stays 0: nothing is known yet
      ++next_run;
    } else {
      const double elapsed_s = rows.time_s[row] - rows.time_s[row - 1];
      for (Eigen::Index j = 0; j < components; ++j) {
        decay_(j, i) = std::exp(-elapsed_s / noise.components[static_cast<std::size_t>(j)].tau_s);
      }
      const Eigen::VectorXd decay = decay_.col(i);
      covariance = decay.asDiagonal() * covariance * decay.asDiagonal();
      covariance.diagonal().array() += variances.array() * (1 - decay.array().square());
    }
    const Eigen::VectorXd to_sum = covariance.rowwise().sum();
    const double variance = to_sum.sum() + noise.white_variance / weights[i];
    scale_[i] = 1 / std::sqrt(variance);
    gain_.col(i) = to_sum / variance;
    covariance -= to_sum * to_sum.transpose() / variance;
  }
}

Eigen::MatrixXd Whitening::apply(const Eigen::MatrixXd& matrix) const {
  Eigen::MatrixXd white(matrix.rows(), matrix.cols());
  Eigen::VectorXd state(decay_.rows());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    state.setZero();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      state = state.cwiseProduct(decay_.col(i));
      const double innovation = matrix(i, column) - state.sum();
      white(i, column) = scale_[i] * innovation;
      state += gain_.col(i) * innovation;
    }
  }
  return white;
}

}  // namespace fogcomp
