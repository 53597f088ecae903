#pragma once

#include <Eigen/Core>
#include <memory>

#include "research/comparator.hpp"

namespace fogcomp::research {

/// Adaptive neuro-fuzzy inference (Jang, IEEE Trans. SMC 23(3), 1993): first-order Sugeno rules
/// over a grid of Gaussian memberships, hybrid learning: in every epoch the rules' straight lines
/// by least squares, then a step of the memberships' centres and widths down the gradient.
class Anfis {
 public:
  static constexpr Eigen::Index kMemberships = 3;  ///< per input

  /// Rows x 2.
  Anfis(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target, int epochs);

  Eigen::VectorXd values(const Eigen::MatrixXd& inputs) const;
  double mean_square() const { return mean_square_; }

 private:
  static constexpr Eigen::Index kInputs = 2;
  static constexpr Eigen::Index kRules = kMemberships * kMemberships;
  using Memberships = Eigen::Matrix<double, kMemberships, kInputs>;

  Eigen::MatrixXd normalised(const Eigen::MatrixXd& inputs) const;
  /// Rows x rules: each rule's share in a row.
  Eigen::MatrixXd shares(const Eigen::MatrixXd& x) const;
  /// Rows x (rules x (1 + inputs)): what the rules' lines are solved from.
  Eigen::MatrixXd design(const Eigen::MatrixXd& x, const Eigen::MatrixXd& share) const;
  /// Each rule's line in a row.
  Eigen::MatrixXd lines(const Eigen::MatrixXd& x) const;
  void move_memberships(const Eigen::MatrixXd& x, const Eigen::MatrixXd& share,
                        const Eigen::VectorXd& error, double step);

  Eigen::RowVector2d centre_;
  Eigen::RowVector2d half_range_;
  Memberships places_;
  Memberships widths_;
  Eigen::VectorXd consequents_;  // rule by rule: constant, slope by each input
  double mean_square_ = 0;
};

std::unique_ptr<Comparator> make_anfis(const ComparatorSettings& settings);

}  // namespace fogcomp::research
