#pragma once

#include <Eigen/Core>
#include <functional>

#include "fit/perceptron.hpp"

namespace fogcomp::fit {

/// Makes rows x any of the rows that their noise makes dependent rows of independent noise with
/// variance 1: linear, and the same for the first rows alone.
using Whiten = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// Rows that a network is trained or judged on, all at once ("full batch").
class Batch {
 public:
  /// `inputs` rows x inputs, `target` a value per row, both normalised to about +-1; `weights` say
  /// how much each row counts (not negative). `whiten` (may be empty) serves errors() and takes the
  /// rows' weights into account by itself.
  Batch(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
        const Eigen::VectorXd& weights, Whiten whiten = {});

  Eigen::Index rows() const { return inputs_.rows(); }
  Eigen::Index inputs() const { return inputs_.cols(); }

  /// Weighted mean of (target - output)^2.
  double mean_square(const Perceptron& shape, const Eigen::VectorXd& weights) const;
  /// The same, and its derivative by every weight.
  double mean_square(const Perceptron& shape, const Eigen::VectorXd& weights,
                     Eigen::VectorXd& gradient) const;

  /// target - output, whitened, or where there is nothing to whiten with times sqrt(row weight);
  /// and optionally its derivative by every weight (rows x weights).
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

}  // namespace fogcomp::fit
