#include "network/trainer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/input_error.hpp"
#include "unit/network/network_data.hpp"

namespace fogcomp::network {
namespace {

NetworkSettings settings_for(const std::string& trainer) {
  NetworkSettings settings;
  settings.hidden = 6;
  settings.scaling = TargetScaling::min_max;
  settings.trainer = trainer;
  settings.training.epochs = 2000;
  settings.training.iterations = 60;
  return settings;
}

class EveryTrainer : public testing::TestWithParam<std::string> {};

TEST_P(EveryTrainer, LearnsASmoothSurface) {
  const NetworkTask task = fog::test::smooth_task(600, 0.05, 1);
  const TrainedNetwork network = train_network(task, settings_for(GetParam()));
  EXPECT_GT(network.rms_before_dph, 0.3);
  // The noise is 0.029 rms; in so few epochs gradient descent is not there yet.
  const double max = GetParam() == "lm" ? 0.035 : 0.1;
  EXPECT_LT(network.rms_after_dph, max);
  const NetworkTask fresh = fog::test::smooth_task(600, 0, 2);
  const double error =
      (fresh.target_dph - network.drift_dph(fresh.inputs)).norm() / std::sqrt(600.0);
  EXPECT_LT(error, max);
}

TEST_P(EveryTrainer, GivesTheSameWeightsForTheSameSeed) {
  const NetworkTask task = fog::test::smooth_task(200, 0.05, 1);
  NetworkSettings settings = settings_for(GetParam());
  settings.training.epochs = 100;
  const TrainedNetwork first = train_network(task, settings);
  EXPECT_EQ(train_network(task, settings).result.weights, first.result.weights);
  settings.training.seed = 2;
  EXPECT_NE(train_network(task, settings).result.weights, first.result.weights);
}

TEST_P(EveryTrainer, KeepsTheBestSoFarWhenInterrupted) {
  const NetworkTask task = fog::test::smooth_task(200, 0.05, 1);
  NetworkSettings settings = settings_for(GetParam());
  int asked = 0;
  settings.training.go_on = [&asked](double) { return ++asked < 4; };
  const TrainedNetwork network = train_network(task, settings);
  EXPECT_TRUE(network.result.interrupted);
  ASSERT_EQ(network.result.weights.size(), 25);
  EXPECT_TRUE(network.result.weights.allFinite());
}

// The held-out run has no noise; the training run is mostly noise, which must not be learnt.
TEST_P(EveryTrainer, StopsWhereTheHeldOutRunIsPredictedBest) {
  const NetworkTask noisy = fog::test::smooth_task(60, 1, 1);
  const NetworkTask clean = fog::test::smooth_task(400, 0, 2);
  NetworkTask task;
  task.inputs.resize(460, 2);
  task.inputs << noisy.inputs, clean.inputs;
  task.target_dph.resize(460);
  task.target_dph << noisy.target_dph, clean.target_dph;
  task.weights.setOnes(460);
  task.run_starts = {0, 60};
  NetworkSettings settings = settings_for(GetParam());
  settings.hidden = 20;
  const auto held_out_error = [&](const TrainedNetwork& network) {
    return (clean.target_dph - network.drift_dph(clean.inputs)).norm() / 20;
  };
  const double stopped = held_out_error(train_network(task, settings));
  const double alone = held_out_error(train_network(noisy, settings));
  // lm's regularisation finds the same optimum.
  const double max = GetParam() == "lm" ? 1.02 * alone : 0.8 * alone;
  EXPECT_LE(stopped, max) << "held-out rms, against " << alone;
}

INSTANTIATE_TEST_SUITE_P(Training, EveryTrainer, testing::ValuesIn(trainer_names()),
                         [](const auto& each) {
                           std::string name = each.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST(Trainers, StopAtTheGoal) {
  const NetworkTask task = fog::test::smooth_task(300, 0.05, 1);
  NetworkSettings settings = settings_for("traingdx");
  settings.training.epochs = 100'000;
  settings.training.goal = 0.02;
  const TrainedNetwork network = train_network(task, settings);
  EXPECT_LE(network.result.mean_square, 0.02);
  EXPECT_LT(network.result.epochs, 5000);
}

TEST(Trainers, SwarmAndPopulationStartBackpropagationFromABetterPlace) {
  const NetworkTask task = fog::test::smooth_task(300, 0.05, 1);
  const auto mean_square = [&](const std::string& trainer) {
    NetworkSettings settings = settings_for(trainer);
    settings.training.epochs = 1;
    return train_network(task, settings).result.mean_square;
  };
  EXPECT_LT(mean_square("pso-bp"), 0.5 * mean_square("traingdx"));
  EXPECT_LT(mean_square("ga-bp"), 0.5 * mean_square("traingdx"));
}

TEST(LevenbergMarquardt, LearnsNextToNothingFromNoise) {
  NetworkTask task = fog::test::smooth_task(2000, 0, 1);
  Uniform uniform(5);
  for (double& value : task.target_dph) value = uniform.within(1);
  NetworkSettings settings = settings_for("lm");
  settings.scaling = TargetScaling::about_zero;
  const TrainedNetwork network = train_network(task, settings);
  ASSERT_TRUE(network.result.effective_parameters.has_value());
  EXPECT_LT(*network.result.effective_parameters, 10);
  EXPECT_LT(network.drift_dph(task.inputs).norm() / std::sqrt(2000.0), 0.05);
}

TEST(Trainers, UnknownNameIsRefused) {
  EXPECT_THROW(find_trainer("adam"), InputError);
}

}  // namespace
}  // namespace fogcomp::network
