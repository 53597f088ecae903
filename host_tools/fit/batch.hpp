#pragma once

#include <Eigen/Core>
#include <functional>

#include "fit/batch_kernels.hpp"
#include "fit/perceptron.hpp"

namespace fogcomp {

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

  Eigen::Index rows() const { return rows_; }
  Eigen::Index inputs() const { return input_values_.cols(); }

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
  Whiten whiten_;
  const BatchKernels* kernels_;
};

}  // namespace fogcomp
