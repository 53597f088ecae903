#include "network/training_rows.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace fogcomp::network {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Dynamic;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rows per chunk: the values of all neurons for a chunk fit the first-level cache.
constexpr Index kChunk = 128;
using Values = Eigen::Array<double, Dynamic, 1, Eigen::ColMajor, kChunk, 1>;

// GCC compiles these functions for any processor and for AVX2; the loader selects. No fused
// multiply-add, so both give the same bits.
#if defined(__x86_64__) && !defined(__clang__)
#define FOGCOMP_ANY_PROCESSOR [[gnu::target_clones("avx2", "default")]]
#else
#define FOGCOMP_ANY_PROCESSOR
#endif

// 1 / (1 + exp(-x)) for x within +-700. With -x = n ln 2 + r and Cody and Waite's rational form
// exp(r) = (q + p) / (q - p) (coefficients: Cephes, exp.c) it is (q - p) / ((q - p) + 2^n (q + p)):
// one division. No branch or call, so that the compiler vectorises the loop: three times as fast as
// Eigen's.
FOGCOMP_ANY_PROCESSOR void logistic_of_each(double* x, Index size) {
  // Adding this puts round(v) + 1023, the exponent of 2^round(v), into the lowest 12 bits.
  constexpr double kRound = 6755399441055744.0 + 1023;
  constexpr double kLog2E = 1.4426950408889634;
  constexpr double kLn2High = 6.93145751953125e-1;
  constexpr double kLn2Low = 1.42860682030941723212e-6;
  for (Index i = 0; i < size; ++i) {
    const double shifted = kRound - x[i] * kLog2E;
    const double n = shifted - kRound;
    std::uint64_t exponent = 0;
    std::memcpy(&exponent, &shifted, sizeof exponent);
    exponent <<= 52U;
    double power = 0;
    std::memcpy(&power, &exponent, sizeof power);
    const double r = -x[i] - n * kLn2High - n * kLn2Low;
    const double square = r * r;
    const double p =
        r * ((1.26177193074810590878e-4 * square + 3.02994407707441961300e-2) * square +
             9.99999999999999999910e-1);
    const double q = ((3.00198505138664455042e-6 * square + 2.52448340349684104192e-3) * square +
                      2.27265548208155028766e-1) *
                         square +
                     2.0;
    x[i] = (q - p) / ((q - p) + power * (q + p));
  }
}

template <class Array>
void activate_all(fog::Activation activation, Array& x) {
  constexpr double kMax = 700;  // beyond, the result is 0 or 1 to the last bit
  switch (activation) {
    case fog::Activation::logsig:
      x = x.max(-kMax).min(kMax);
      logistic_of_each(x.data(), x.size());
      break;
    case fog::Activation::tansig:
      x = (2 * x).max(-kMax).min(kMax);
      logistic_of_each(x.data(), x.size());
      x = 2 * x - 1;
      break;
    case fog::Activation::linear:
      break;
  }
}

template <class Array>
Values slopes(fog::Activation activation, const Array& y) {
  switch (activation) {
    case fog::Activation::logsig:
      return y * (1 - y);
    case fog::Activation::tansig:
      return 1 - y.square();
    case fog::Activation::linear:
      break;
  }
  return Values::Ones(y.size());
}

// Evaluates the network over the rows, chunk by chunk.
class ChunkLoop {
 public:
  ChunkLoop(const Perceptron& shape, const VectorXd& w, const ArrayXXd& inputs)
      : shape_(shape), w_(w), inputs_(inputs) {}

  // The chunk's part of a vector with one value per row.
  template <class Column>
  auto part(Column&& column) const {
    return std::forward<Column>(column).segment(first_, count_);
  }

  // Evaluates the next chunk; false at the end.
  bool next() {
    first_ += count_;
    count_ = std::min(kChunk, inputs_.rows() - first_);
    if (count_ <= 0) return false;
    hidden_.resize(count_, shape_.hidden);
    output_.setConstant(count_, w_[shape_.output_bias()]);
    for (Index j = 0; j < shape_.hidden; ++j) {
      auto neuron = hidden_.col(j);
      neuron.setConstant(w_[shape_.hidden_bias() + j]);
      for (Index i = 0; i < shape_.inputs; ++i) {
        neuron += w_[shape_.hidden_weight(j) + i] * part(inputs_.col(i));
      }
      activate_all(shape_.hidden_activation, neuron);
      output_ += w_[shape_.output_weight() + j] * neuron;
    }
    activate_all(shape_.output_activation, output_);
    return true;
  }

  const Values& output() const { return output_; }

  // Calls put(weight, values) for each weight: `outer`, one value per row of the chunk, times the
  // derivative of the row's output by the weight.
  template <class Put>
  void each_derivative(Values outer, const Put& put) const {
    outer *= slopes(shape_.output_activation, output_);
    put(shape_.output_bias(), outer);
    for (Index j = 0; j < shape_.hidden; ++j) {
      const auto neuron = hidden_.col(j);
      put(shape_.output_weight() + j, outer * neuron);
      const Values through =
          w_[shape_.output_weight() + j] * outer * slopes(shape_.hidden_activation, neuron);
      put(shape_.hidden_bias() + j, through);
      for (Index i = 0; i < shape_.inputs; ++i) {
        put(shape_.hidden_weight(j) + i, through * part(inputs_.col(i)));
      }
    }
  }

 private:
  const Perceptron& shape_;
  const VectorXd& w_;
  const ArrayXXd& inputs_;
  Index first_ = 0;
  Index count_ = 0;
  Eigen::Array<double, Dynamic, Dynamic, Eigen::ColMajor, kChunk, kMaxTrainedHidden> hidden_;
  Values output_;
};

}  // namespace

TrainingRows::TrainingRows(const MatrixXd& inputs, const VectorXd& target, const VectorXd& weights,
                           Whiten whiten)
    : inputs_(inputs),
      target_(target),
      weights_(weights),
      total_weight_(weights.sum()),
      whiten_(std::move(whiten)) {}

double TrainingRows::mean_square(const Perceptron& shape, const VectorXd& weights) const {
  double cost = 0;
  for (ChunkLoop walk(shape, weights, inputs_); walk.next();) {
    const Values error = walk.part(target_) - walk.output();
    cost += (walk.part(weights_) * error.square()).sum();
  }
  return cost / total_weight_;
}

double TrainingRows::mean_square(const Perceptron& shape, const VectorXd& weights,
                                 VectorXd& gradient) const {
  double cost = 0;
  gradient.setZero(shape.size());
  for (ChunkLoop walk(shape, weights, inputs_); walk.next();) {
    const Values error = walk.part(target_) - walk.output();
    cost += (walk.part(weights_) * error.square()).sum();
    walk.each_derivative(-2 * walk.part(weights_) * error, [&](Index weight, const auto& values) {
      gradient[weight] += values.sum();
    });
  }
  gradient /= total_weight_;
  return cost / total_weight_;
}

void TrainingRows::errors(const Perceptron& shape, const VectorXd& weights, VectorXd& errors,
                          MatrixXd* jacobian) const {
  const ArrayXd roots = whitens() ? ArrayXd::Ones(rows()) : ArrayXd(weights_.sqrt());
  errors.resize(rows());
  if (jacobian != nullptr) jacobian->resize(rows(), shape.size());
  for (ChunkLoop walk(shape, weights, inputs_); walk.next();) {
    walk.part(errors) = walk.part(roots) * (walk.part(target_) - walk.output());
    if (jacobian == nullptr) continue;
    walk.each_derivative(-walk.part(roots), [&](Index weight, const auto& values) {
      walk.part(jacobian->col(weight)) = values;
    });
  }
  if (!whitens()) return;
  errors = whiten_(errors);
  if (jacobian != nullptr) *jacobian = whiten_(*jacobian);
}

}  // namespace fogcomp::network
