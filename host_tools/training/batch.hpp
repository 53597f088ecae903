#pragma once

#include <Eigen/Core>

#include "training/batch_kernels.hpp"
#include "training/perceptron.hpp"

namespace fogcomp {

/// Rows that a network is trained or judged on, all at once ("full batch").
class Batch {
 public:
  /// `inputs` rows x inputs, `target` a value per row, both normalised to about +-1; `weights` say
  /// how much each row counts (not negative).
  Batch(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& target,
        const Eigen::VectorXd& weights);

  Eigen::Index rows() const { return rows_; }
  Eigen::Index inputs() const { return input_values_.cols(); }

  /// Weighted mean of (target - output)^2.
  double mean_square(const Perceptron& shape, const Eigen::VectorXd& weights) const;
  /// The same, and its derivative by every weight.
  double mean_square(const Perceptron& shape, const Eigen::VectorXd& weights,
                     Eigen::VectorXd& gradient) const;

  /// sqrt(row weight) * (target - output), and optionally its derivative by every weight
  /// (rows x weights).
  void errors(const Perceptron& shape, const Eigen::VectorXd& weights, Eigen::VectorXd& errors,
              Eigen::MatrixXd* jacobian) const;

  double total_weight() const { return total_weight_; }

  /// The processor's own kernels unless set: tests and benches compare.
  void set_kernels(const BatchKernels& kernels) { kernels_ = &kernels; }

 private:
  BatchColumns columns() const;

  Eigen::Index rows_;
  Eigen::Index padded_;
  double total_weight_;
  Eigen::MatrixXd input_values_;  // padded rows x inputs; the padding has weight 0
  Eigen::VectorXd target_;
  Eigen::VectorXd weights_;
  const BatchKernels* kernels_;
};

}  // namespace fogcomp
