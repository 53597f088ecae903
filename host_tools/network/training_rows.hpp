#pragma once

#include <Eigen/Core>
#include <functional>

#include "network/perceptron.hpp"

namespace fogcomp::network {

/// Whitens rows x any number of columns: turns rows with dependent noise into rows of independent
/// noise with variance 1. Linear; the first rows do not depend on later ones.
using Whiten = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// The rows for training or judging a network, all at once ("full batch").
class TrainingRows {
 public:
  /// `inputs`: rows x inputs; `target`: one value per row; both normalised to about +-1. `weights`:
  /// weight of each row, not negative. `whiten` (may be empty) is used by errors() and includes the
  /// rows' weights.
  TrainingRows(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
               const Eigen::VectorXd& weights, Whiten whiten = {});

  Eigen::Index rows() const { return inputs_.rows(); }
  Eigen::Index inputs() const { return inputs_.cols(); }

  /// Weighted mean of (target - output)^2.
  double mean_square(const Perceptron& shape, const Eigen::VectorXd& weights) const;
  /// The same, with its derivative by every weight.
  double mean_square(const Perceptron& shape, const Eigen::VectorXd& weights,
                     Eigen::VectorXd& gradient) const;

  /// target - output, whitened or, without `whiten`, times sqrt(row weight); optionally its
  /// derivative by every weight (rows x weights).
  void errors(const Perceptron& shape, const Eigen::VectorXd& weights, Eigen::VectorXd& errors,
              Eigen::MatrixXd* jacobian) const;

  /// Whether the noise of errors() has a known variance, 1.
  bool whitens() const { return whiten_ != nullptr; }

 private:
  Eigen::ArrayXXd inputs_;
  Eigen::ArrayXd target_;
  Eigen::ArrayXd weights_;
  double total_weight_;
  Whiten whiten_;
};

}  // namespace fogcomp::network
