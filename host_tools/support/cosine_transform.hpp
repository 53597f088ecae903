#pragma once

#include <Eigen/Core>

namespace fogcomp {

/// Orthonormal cosine transform (DCT-II) of every column, of any number of rows: row k is the
/// amplitude of k half cycles. It diagonalises the covariance of white noise and of a random walk
/// about its mean, and nearly that of flicker noise.
Eigen::MatrixXd cosine_transform(const Eigen::Ref<const Eigen::MatrixXd>& columns);

}  // namespace fogcomp
