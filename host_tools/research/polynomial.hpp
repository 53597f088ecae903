#pragma once

#include <Eigen/Core>
#include <memory>

#include "research/comparator.hpp"

namespace fogcomp::research {

/// Least-squares polynomial of total order `order` in any number of variables, each mapped to +-1
/// over the rows it is fitted to.
class Polynomial {
 public:
  static constexpr int kMaxOrder = 9;

  /// Rows x variables. `order` 1 to kMaxOrder.
  Polynomial(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target, int order);

  Eigen::VectorXd values(const Eigen::MatrixXd& inputs) const;

  /// The order from 1 to kMaxOrder whose cross-validated error is smallest.
  static int best_order(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target);

 private:
  Eigen::MatrixXd terms(const Eigen::MatrixXd& inputs) const;

  int order_;
  Eigen::RowVectorXd centre_;
  Eigen::RowVectorXd half_range_;
  Eigen::VectorXd coefficients_;
};

std::unique_ptr<Comparator> make_polynomial(const ComparatorSettings& settings);
std::unique_ptr<Comparator> make_rate_polynomial(const ComparatorSettings& settings);

}  // namespace fogcomp::research
