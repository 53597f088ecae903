#include "diagnosis/network_learnt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/effect_list.hpp"
#include "support/least_squares.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

// One neuron in the linear part of its curve: `size_dph` times the input over its range.
model::RealNetwork nearly_linear(const model::RealInput& input, double size_dph) {
  model::RealNetwork network = fog::test::network_of({input});
  network.hidden.weights = Eigen::MatrixXd::Constant(1, 1, 0.01);
  network.hidden.biases = Eigen::VectorXd::Zero(1);
  network.hidden.activation = fog::Activation::tansig;
  network.output.activation = fog::Activation::linear;
  network.output.weights = Eigen::MatrixXd::Constant(1, 1, 100);
  network.output.biases = Eigen::VectorXd::Zero(1);
  network.centre_dph = 0;
  network.amplitude_dph = size_dph;
  return network;
}

class NetworkLearntTest : public testing::Test {
 protected:
  NetworkLearntTest() : series_(model_, series::Phase::zero) {
    series_.add(series::make_blocks(fog::test::recording_of(model_, {}, 1)));
    for (const char* const effect :
         {"thermal_hysteresis:radius=5", "temperature_rate", "bias_step:at=9000"}) {
      const model::EffectTerm term = model::parse_effects(effect)[0];
      const Eigen::MatrixXd columns = without_mean(series_.regressors(term)).columns;
      candidates_.push_back({term.name, {{term, orthonormal(columns).cast<float>()}}});
    }
  }
  static VisiblePart without_mean(const Eigen::MatrixXd& columns) {
    VisiblePart part{columns.rowwise() - columns.colwise().mean(), {}};
    part.visible =
        part.columns.colwise().norm().cwiseQuotient(columns.colwise().norm()).transpose();
    return part;
  }
  NetworkLearnt asked(const model::RealNetwork& network) const {
    return ask_network(network, series_, candidates_, without_mean);
  }

  model::Model model_ = fog::test::truth();
  series::SignalSeries series_;
  std::vector<Candidate> candidates_;
};

TEST_F(NetworkLearntTest, IsTheEffectThatTheNetworkIs) {
  const NetworkLearnt learnt =
      asked(nearly_linear({fog::NetworkInput::temperature_rate, 0, 1, 0}, 0.2));
  ASSERT_EQ(learnt.effects.size(), 2U);  // an event is no answer
  EXPECT_EQ(learnt.effects[0].term.name, "temperature_rate");
  EXPECT_GT(learnt.effects[0].share, 0.99);
  EXPECT_LT(learnt.effects[1].share, learnt.effects[0].share);
  EXPECT_GT(learnt.beyond_effects, 0.9);  // it has hardly a mean
  double square_sum = 0;
  for (const auto& signals : series_.rows().signals) {
    square_sum += std::pow(0.2 * signals.temperature_rate, 2);
  }
  EXPECT_NEAR(learnt.rms_dph, std::sqrt(square_sum / static_cast<double>(series_.rows().size())),
              0.01 * learnt.rms_dph);
}

// What the model's own effects can describe does not count as learnt by the network.
TEST_F(NetworkLearntTest, IsNothingBeyondTheEffectsWhereTheseDoTheSame) {
  model::RealNetwork constant = nearly_linear({fog::NetworkInput::temperature, 20, 1e6, 0}, 1e-3);
  constant.centre_dph = 0.5;
  const NetworkLearnt learnt = asked(constant);
  EXPECT_NEAR(learnt.rms_dph, 0.5, 1e-3);
  EXPECT_LT(learnt.beyond_effects, 1e-6);
}

}  // namespace
}  // namespace fogcomp::diagnosis
