#include <gtest/gtest.h>

#include <numeric>

#include "compare/comparison.hpp"
#include "support/input_error.hpp"
#include "unit/fit/recording_with_steps.hpp"

namespace {

using namespace fog::test;

TEST(BiasSteps, AreNotFoundInWhiteAndFlickerNoise) {
  EXPECT_TRUE(fit({noisy_recording(1)}, kStepEffects).identified.steps.empty());
}

TEST(BiasSteps, AreTermsOfTheModelThatLeaveTheOthersAlone) {
  fogcomp::recording::Recording recording = noisy_recording(1);
  add_step(recording, 5300, -5 * kWhiteDph);
  const FittedSteps result = fit({recording}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 1U);
  EXPECT_NEAR(result.identified.steps[0].time_s, 5300, 30);
  EXPECT_LT(result.identified.steps[0].time_sigma_s, 20);
  EXPECT_GE(result.identified.masked, 1U);
  EXPECT_EQ(result.model.terms.back().name, "bias_step");
  EXPECT_EQ(result.model.terms.back().parameters[0].value, result.identified.steps[0].time_s);
  EXPECT_NEAR(result.model.terms[2].coefficients_dph[0].value,
              truth().terms[2].coefficients_dph[0].value,
              4 * result.model.terms[2].coefficients_dph[0].sigma);
}

TEST(BiasSteps, SeveralAreFoundAndAWildRowIsNone) {
  fogcomp::recording::Recording recording = noisy_recording(3);
  add_step(recording, 9000, 0.15);
  add_step(recording, 21000, -0.2);
  add_step(recording, 30000, 0.1);
  recording.rate_dph[1500] += 30;
  const FittedSteps result = fit({recording}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 3U);
  double sum = 0;
  for (const fogcomp::fit::FoundStep& step : result.identified.steps) sum += step.size_dph;
  EXPECT_NEAR(sum, 0.05, 0.03);
}

TEST(BiasSteps, BelongToTheRecordingInWhichTheyLie) {
  fogcomp::recording::Recording second = noisy_recording(5);
  add_step(second, 15000, 0.2);
  const FittedSteps result = fit({noisy_recording(4), second}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 1U);
  EXPECT_EQ(result.identified.steps[0].run, 1U);
  EXPECT_NEAR(result.identified.steps[0].time_s, 15000, 20);
  EXPECT_NEAR(result.identified.steps[0].size_dph, 0.2, 0.02);
}

double rms_left_dph(const fogcomp::model::Model& model,
                    const fogcomp::recording::Recording& recording) {
  const auto run = fogcomp::runs::run_of(recording, {model.average_s});
  return fogcomp::compare::compare_with(model, run, model.average_s).whole.rms_dph;
}

fogcomp::recording::Recording shifted(fogcomp::recording::Recording recording, double dph) {
  for (double& rate : recording.rate_dph) rate += dph;
  return recording;
}

constexpr double kJump_dph = 0.2;
constexpr double kLittleAboveNoise_dph = 1.3 * kWhiteDph;

fogcomp::recording::Recording recording_with_jump() {
  fogcomp::recording::Recording recording = noisy_recording(5);
  add_step(recording, 15000, kJump_dph);
  return recording;
}

// What a fit takes for a step of one recording must not be subtracted from another.
TEST(BiasSteps, ActOnTheirRecordingOnly) {
  const FittedSteps result = fit({noisy_recording(4), recording_with_jump()}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 1U);
  EXPECT_LT(rms_left_dph(result.model, recording_with_jump()), kLittleAboveNoise_dph);
  EXPECT_LT(rms_left_dph(result.model, noisy_recording(4)), kLittleAboveNoise_dph);
  EXPECT_LT(rms_left_dph(result.model, noisy_recording(6)), kLittleAboveNoise_dph);

  fogcomp::series::SignalSeries other(result.model);
  other.add(fogcomp::series::make_blocks(noisy_recording(6)));
  EXPECT_TRUE(other.regressors(result.model.terms.back()).isZero());
  EXPECT_EQ(other.acting(result.model.terms).size(), result.model.terms.size() - 1);
}

TEST(BiasSteps, OfTheOnlyRecordingLeaveTheBiasThatFollows) {
  const FittedSteps result = fit({recording_with_jump()}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 1U);
  EXPECT_EQ(result.identified.steps[0].others_part, 1);
  EXPECT_NEAR(result.identified.steps[0].size_dph, kJump_dph, 0.02);
  EXPECT_LT(rms_left_dph(result.model, recording_with_jump()), kLittleAboveNoise_dph);
  EXPECT_LT(rms_left_dph(result.model, shifted(noisy_recording(6), kJump_dph)),
            kLittleAboveNoise_dph);
  fogcomp::series::SignalSeries own(result.model);
  own.add(fogcomp::series::make_blocks(recording_with_jump()));
  const Eigen::VectorXd regressor = own.regressors(result.model.terms.back());
  EXPECT_EQ(regressor.minCoeff(), -1);
  EXPECT_EQ(regressor.maxCoeff(), 0);
}

TEST(BiasSteps, LeaveTheBiasThatTheOtherRecordingsHave) {
  for (const double others_dph : {0.0, kJump_dph}) {
    const FittedSteps result =
        fit({recording_with_jump(), shifted(noisy_recording(4), others_dph)}, kStepEffects);
    ASSERT_EQ(result.identified.steps.size(), 1U);
    EXPECT_EQ(result.identified.steps[0].others_part, others_dph != 0 ? 1 : 0);
    EXPECT_LT(rms_left_dph(result.model, recording_with_jump()), kLittleAboveNoise_dph);
    EXPECT_LT(rms_left_dph(result.model, shifted(noisy_recording(6), others_dph)),
              kLittleAboveNoise_dph);
  }
}

fogcomp::recording::Recording telegraph_recording(std::uint64_t seed) {
  fogcomp::recording::Recording recording = noisy_recording(seed);
  add_step(recording, 9000, kJump_dph);
  add_step(recording, 19000, -kJump_dph);
  add_step(recording, 27000, kJump_dph);
  return recording;
}

// The next run of a gyro whose bias goes back and forth is at the last level by chance only.
TEST(BiasSteps, ThatComeAgainLeaveTheMean) {
  const FittedSteps result = fit({telegraph_recording(6)}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 3U);
  double mean_dph = 0;
  for (const fogcomp::fit::FoundStep& step : result.identified.steps) {
    EXPECT_GT(step.others_part, 0);
    EXPECT_LT(step.others_part, 1);
    mean_dph += step.others_part * step.size_dph;
  }
  const std::vector<double> with = telegraph_recording(6).rate_dph;
  const std::vector<double> without = noisy_recording(6).rate_dph;
  const double sum_dph = std::accumulate(with.begin(), with.end(), 0.0) -
                         std::accumulate(without.begin(), without.end(), 0.0);
  EXPECT_NEAR(mean_dph, sum_dph / static_cast<double>(with.size()), 0.01);
  EXPECT_LT(rms_left_dph(result.model, telegraph_recording(6)), kLittleAboveNoise_dph);
  EXPECT_LT(rms_left_dph(result.model, shifted(noisy_recording(7), mean_dph)),
            kLittleAboveNoise_dph);
}

// That both end at the same level is no reason to expect it.
TEST(BiasSteps, ThatComeAgainInEachRecordingLeaveTheirMeans) {
  const FittedSteps result = fit({telegraph_recording(6), telegraph_recording(4)}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 6U);
  for (const fogcomp::fit::FoundStep& step : result.identified.steps) {
    EXPECT_GT(step.others_part, 0);
    EXPECT_LT(step.others_part, 1);
  }
}

// A recording without steps tells which level the gyro has where nothing happens.
TEST(BiasSteps, ThatComeAgainLeaveTheBiasThatTheOtherRecordingsHave) {
  const FittedSteps result =
      fit({telegraph_recording(6), shifted(noisy_recording(4), kJump_dph)}, kStepEffects);
  ASSERT_EQ(result.identified.steps.size(), 3U);
  EXPECT_LT(rms_left_dph(result.model, telegraph_recording(6)), kLittleAboveNoise_dph);
  EXPECT_LT(rms_left_dph(result.model, shifted(noisy_recording(7), kJump_dph)),
            kLittleAboveNoise_dph);
}

TEST(BiasSteps, WithATimeAreNotSearchedForAndAloneAreRefused) {
  fogcomp::recording::Recording recording = noisy_recording(6);
  add_step(recording, 15000, 0.2);
  const FittedSteps given = fit({recording}, "bias,bias_temperature,bias_step:at=15000");
  EXPECT_TRUE(given.identified.steps.empty());
  EXPECT_NEAR(given.model.terms.back().coefficients_dph[0].value, 0.2, 0.05);
  EXPECT_THROW(fit({recording}, "bias_step"), fogcomp::InputError);
}

}  // namespace
