#include "fit/batch.hpp"

#include <utility>

namespace fogcomp {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Batch::Batch(const MatrixXd& inputs, const VectorXd& target, const VectorXd& weights, Whiten whiten)
    : rows_(target.size()),
      total_weight_(weights.sum()),
      whiten_(std::move(whiten)),
      kernels_(&best_batch_kernels()) {
  constexpr auto kStep = static_cast<Index>(kBatchStep);
  padded_ = (rows_ + kStep - 1) / kStep * kStep;
  input_values_.setZero(padded_, inputs.cols());
  input_values_.topRows(rows_) = inputs;
  target_.setZero(padded_);
  target_.head(rows_) = target;
  weights_.setZero(padded_);
  weights_.head(rows_) = weights;
}

BatchColumns Batch::columns() const {
  BatchColumns columns;
  for (Index i = 0; i < input_values_.cols(); ++i) {
    columns.inputs.push_back(input_values_.col(i).data());
  }
  columns.target = target_.data();
  columns.weights = weights_.data();
  columns.rows = static_cast<std::size_t>(padded_);
  return columns;
}

double Batch::mean_square(const Perceptron& shape, const VectorXd& weights) const {
  return kernels_->cost(shape, weights.data(), columns()) / total_weight_;
}

double Batch::mean_square(const Perceptron& shape, const VectorXd& weights,
                          VectorXd& gradient) const {
  gradient.resize(shape.size());
  const double cost =
      kernels_->cost_and_gradient(shape, weights.data(), columns(), gradient.data());
  gradient /= total_weight_;
  return cost / total_weight_;
}

void Batch::errors(const Perceptron& shape, const VectorXd& weights, VectorXd& errors,
                   MatrixXd* jacobian) const {
  MatrixXd hidden(padded_, shape.hidden);
  VectorXd output(padded_);
  kernels_->outputs(shape, weights.data(), columns(), hidden.data(), output.data());
  const VectorXd roots = whitens() ? VectorXd::Ones(padded_) : VectorXd(weights_.cwiseSqrt());
  errors = roots.cwiseProduct(target_ - output).head(rows_);
  if (whitens()) errors = whiten_(errors);
  if (jacobian == nullptr) return;
  jacobian->resize(rows_, shape.size());
  const auto slope_of = [](fog::Activation activation) {
    return [activation](double y) { return activation_slope(activation, y); };
  };
  const VectorXd outer =
      -roots.cwiseProduct(output.unaryExpr(slope_of(shape.output_activation))).head(rows_);
  for (Index j = 0; j < shape.hidden; ++j) {
    const auto neuron = hidden.col(j).head(rows_);
    const VectorXd through =
        weights[shape.output_weight() + j] *
        outer.cwiseProduct(neuron.unaryExpr(slope_of(shape.hidden_activation)));
    for (Index i = 0; i < shape.inputs; ++i) {
      jacobian->col(shape.hidden_weight(j) + i) =
          through.cwiseProduct(input_values_.col(i).head(rows_));
    }
    jacobian->col(shape.hidden_bias() + j) = through;
    jacobian->col(shape.output_weight() + j) = outer.cwiseProduct(neuron);
  }
  jacobian->col(shape.output_bias()) = outer;
  if (whitens()) *jacobian = whiten_(*jacobian);
}

}  // namespace fogcomp
