#include <gtest/gtest.h>

#include "board/verification.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"

namespace fogcomp::board {
namespace {

using model::Model;

Model with_network(double weight) {
  Model model = fog::test::paper_like_model();
  model.network = {};
  model.network.inputs = {{fog::NetworkInput::temperature, 10, 50},
                          {fog::NetworkInput::temperature_rate, 0, 0.5}};
  model.network.hidden.activation = fog::Activation::logsig;
  model.network.hidden.weights = weight * Eigen::MatrixXd::Ones(3, 2);
  model.network.hidden.biases = Eigen::Vector3d(-0.5, 0, 0.5);
  model.network.output.activation = fog::Activation::tansig;
  model.network.output.weights = Eigen::RowVector3d(0.5, -1, 0.75);
  model.network.output.biases = Eigen::VectorXd::Constant(1, 0.1);
  model.network.amplitude_dph = 0.25;
  return model;
}

NetworkError error_of(const Model& exact, const Model& on_board) {
  const BoardTable table = make_board_table(on_board, {});
  return verify_network(exact, read_board_table(table, "test"));
}

TEST(NetworkVerification, IntegersAreAsGoodAsDoubleOverTheWholeBox) {
  const NetworkError error = error_of(with_network(3), with_network(3));
  EXPECT_GT(error.points, 100'000U);
  EXPECT_LT(error.worst_dph, 1e-5);
  EXPECT_GT(error.worst_dph, 0);
}

// Two networks that differ by one weight, compared with their true difference.
TEST(NetworkVerification, SeesAWeightThatIsOff) {
  const NetworkError error = error_of(with_network(3), with_network(3.1));
  EXPECT_GT(error.worst_dph, 4e-4);
  EXPECT_LT(error.worst_dph, 1e-2);
}

// The board has one activation; the others become factors in the weights.
TEST(NetworkVerification, AnyActivationsAreAsGoodAsDouble) {
  for (const fog::Activation hidden : {fog::Activation::logsig, fog::Activation::tansig}) {
    for (const fog::Activation output :
         {fog::Activation::logsig, fog::Activation::tansig, fog::Activation::linear}) {
      Model model = with_network(5);
      model.network.hidden.activation = hidden;
      model.network.output.activation = output;
      model.network.output.weights *= 0.4;  // a linear output is within +-2
      model.network.centre_dph = -0.3;
      EXPECT_LT(error_of(model, model).worst_dph, 1e-5)
          << model::name_of(hidden) << ' ' << model::name_of(output);
    }
  }
}

// Large weights, arguments far beyond +-16, a large drift.
TEST(NetworkVerification, LargeWeightsAndDriftsAreWithinAMillionth) {
  Model model = with_network(250);
  model.network.amplitude_dph = 20000;
  EXPECT_LT(error_of(model, model).worst_dph, 0.1);
}

TEST(NetworkVerification, WhatTheBoardCannotHoldIsRefused) {
  Model linear = with_network(1);
  linear.network.hidden.activation = fog::Activation::linear;
  EXPECT_THROW(make_board_table(linear, {}), InputError);
  EXPECT_THROW(make_board_table(with_network(1e6), {}), InputError);
}

TEST(NetworkVerification, HasNothingToCompareWithoutANetwork) {
  Model model = with_network(3);
  model.network = {};
  EXPECT_EQ(error_of(model, model).points, 0U);
}

}  // namespace
}  // namespace fogcomp::board
