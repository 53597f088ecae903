#pragma once

#include <Eigen/Core>
#include <memory>

#include "research/comparator.hpp"

namespace fogcomp::research {

/// Least-squares support vector regression (Suykens & Vandewalle 1999) with a Gaussian kernel. The
/// full system has one row per sample; here at most kMaxVectors rows, evenly distributed, define
/// the function, and all rows are fitted (subset of regressors, a Nystrom approximation of the
/// kernel: Williams & Seeger, NIPS 2000).
class SupportVectors {
 public:
  static constexpr Eigen::Index kMaxVectors = 120;

  /// `width`: of the kernel, with inputs scaled to +-1. `regularisation`: weight of the function's
  /// norm relative to the mean square error (LS-SVM's 1/gamma, per row).
  SupportVectors(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target, double width,
                 double regularisation);

  Eigen::VectorXd values(const Eigen::MatrixXd& inputs) const;

 private:
  Eigen::MatrixXd kernel(const Eigen::MatrixXd& normalised) const;
  Eigen::MatrixXd normalised(const Eigen::MatrixXd& inputs) const;

  double width_;
  Eigen::RowVectorXd centre_;
  Eigen::RowVectorXd half_range_;
  Eigen::MatrixXd vectors_;
  Eigen::VectorXd coefficients_;
  double bias_ = 0;
};

/// Width and regularisation by cross-validation over a grid.
std::unique_ptr<Comparator> make_support_vectors(const ComparatorSettings& settings);

}  // namespace fogcomp::research
