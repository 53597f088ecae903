#include "network/training_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "network/trainer_parts.hpp"

namespace fogcomp::network {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using fog::Activation;

struct Rows {
  MatrixXd inputs;
  VectorXd target;
  VectorXd weights;
};

Rows random_rows(Index rows, Index inputs) {
  Uniform uniform(3);
  Rows result{MatrixXd(rows, inputs), VectorXd(rows), VectorXd(rows)};
  for (Index i = 0; i < rows; ++i) {
    for (Index k = 0; k < inputs; ++k) result.inputs(i, k) = uniform.within(1);
    result.target[i] = uniform.within(1);
    result.weights[i] = 0.5 + uniform.unit();
  }
  return result;
}

// The definition, a row at a time, with the standard library's functions.
double direct_mean_square(const Perceptron& shape, const VectorXd& weights, const Rows& rows) {
  const model::RealLayer hidden = shape.hidden_layer(weights);
  const model::RealLayer output = shape.output_layer(weights);
  double sum = 0;
  for (Index i = 0; i < rows.target.size(); ++i) {
    VectorXd values = hidden.weights * rows.inputs.row(i).transpose() + hidden.biases;
    for (double& v : values) v = model::activate(hidden.activation, v);
    const double y =
        model::activate(output.activation, output.weights.row(0).dot(values) + output.biases[0]);
    sum += rows.weights[i] * std::pow(rows.target[i] - y, 2);
  }
  return sum / rows.weights.sum();
}

class Shapes : public testing::TestWithParam<Perceptron> {};

TEST_P(Shapes, MeanSquareIsThatOfTheDefinition) {
  const Perceptron& shape = GetParam();
  const Rows rows = random_rows(101, shape.inputs);
  const TrainingRows training(rows.inputs, rows.target, rows.weights);
  const VectorXd weights = shape.first_weights(1);
  EXPECT_NEAR(training.mean_square(shape, weights), direct_mean_square(shape, weights, rows),
              1e-14);
}

TEST_P(Shapes, GradientIsThatOfFiniteDifferences) {
  const Perceptron& shape = GetParam();
  const Rows rows = random_rows(101, shape.inputs);
  const TrainingRows training(rows.inputs, rows.target, rows.weights);
  const VectorXd weights = shape.first_weights(2);
  VectorXd gradient;
  EXPECT_EQ(training.mean_square(shape, weights, gradient), training.mean_square(shape, weights));
  ASSERT_EQ(gradient.size(), shape.size());
  constexpr double kStep = 1e-5;
  for (Index i = 0; i < shape.size(); ++i) {
    const VectorXd step = kStep * VectorXd::Unit(shape.size(), i);
    const double slope = (direct_mean_square(shape, weights + step, rows) -
                          direct_mean_square(shape, weights - step, rows)) /
                         (2 * kStep);
    EXPECT_NEAR(gradient[i], slope, 1e-9) << "weight " << i;
  }
}

TEST_P(Shapes, JacobianGivesTheSameGradient) {
  const Perceptron& shape = GetParam();
  const Rows rows = random_rows(64, shape.inputs);
  const TrainingRows training(rows.inputs, rows.target, rows.weights);
  const VectorXd weights = shape.first_weights(3);
  VectorXd gradient;
  const double mean_square = training.mean_square(shape, weights, gradient);
  VectorXd errors;
  MatrixXd jacobian;
  training.errors(shape, weights, errors, &jacobian);
  EXPECT_NEAR(errors.squaredNorm() / rows.weights.sum(), mean_square, 1e-14);
  const VectorXd from_jacobian = 2 * jacobian.transpose() * errors / rows.weights.sum();
  EXPECT_LT((from_jacobian - gradient).cwiseAbs().maxCoeff(), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Training, Shapes,
                         testing::Values(Perceptron{2, 10, Activation::logsig, Activation::tansig},
                                         Perceptron{1, 1, Activation::tansig, Activation::linear},
                                         Perceptron{3, 32, Activation::tansig, Activation::tansig},
                                         Perceptron{8, 5, Activation::logsig, Activation::linear}));

// One neuron, weight 1: the network is the activation itself.
VectorXd activation_values(Activation activation, const VectorXd& x) {
  const Perceptron shape{1, 1, activation, Activation::linear};
  VectorXd weights(4);
  weights << 1, 0, 1, 0;
  const TrainingRows training(x, VectorXd::Zero(x.size()), VectorXd::Ones(x.size()));
  VectorXd errors;
  training.errors(shape, weights, errors, nullptr);
  return -errors;
}

TEST(Activations, LogisticAndTangentAreAccurateEverywhere) {
  const VectorXd x = VectorXd::LinSpaced(2'000'001, -50, 50);
  const VectorXd logistic = activation_values(Activation::logsig, x);
  const VectorXd tangent = activation_values(Activation::tansig, x);
  double worst_logistic = 0;
  double worst_tangent = 0;
  for (Index i = 0; i < x.size(); ++i) {
    const double exact = static_cast<double>(1 / (1 + std::exp(-static_cast<long double>(x[i]))));
    worst_logistic = std::max(worst_logistic, std::abs(logistic[i] - exact));
    worst_tangent = std::max(worst_tangent, std::abs(tangent[i] - std::tanh(x[i])));
  }
  EXPECT_LE(worst_logistic, 4e-16);
  EXPECT_LE(worst_tangent, 8e-16);
}

TEST(Activations, FarArgumentsSaturate) {
  VectorXd x(4);
  x << -1e300, -800, 800, 1e300;
  const VectorXd logistic = activation_values(Activation::logsig, x);
  EXPECT_NEAR(logistic[0], 0, 1e-300);
  EXPECT_NEAR(logistic[1], 0, 1e-300);
  EXPECT_EQ(logistic[2], 1);
  EXPECT_EQ(logistic[3], 1);
}

}  // namespace
}  // namespace fogcomp::network
