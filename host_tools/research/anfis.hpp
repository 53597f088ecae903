#pragma once

#include <Eigen/Core>
#include <memory>

#include "research/comparator.hpp"

namespace fogcomp::research {

/// Adaptive neuro-fuzzy inference (Jang, IEEE Trans. SMC 23(3), 1993): first-order Sugeno rules
/// over a grid of Gaussian memberships. Hybrid learning: in every epoch the rules' linear functions
/// by least squares, then a gradient step of the memberships' centres and widths.
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
  /// Rows x rules: normalised firing strengths.
  Eigen::MatrixXd shares(const Eigen::MatrixXd& x) const;
  /// Rows x (rules x (1 + inputs)): design matrix of the rules' linear functions.
  Eigen::MatrixXd design(const Eigen::MatrixXd& x, const Eigen::MatrixXd& share) const;
  /// Value of each rule's linear function in a row.
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
