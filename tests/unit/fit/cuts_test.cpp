#include <gtest/gtest.h>

#include <cmath>

#include "compare/comparison.hpp"
#include "unit/fit/recording_with_steps.hpp"

namespace {

using namespace fog::test;

constexpr double kJump_dph = 0.2;
constexpr double kAt_s = 15000;
constexpr double kLittleAboveNoise_dph = 1.3 * kWhiteDph;

fogcomp::recording::Recording recording_with_jump(std::uint64_t seed) {
  fogcomp::recording::Recording recording = noisy_recording(seed);
  add_step(recording, kAt_s, kJump_dph);
  return recording;
}

fogcomp::recording::Recording shifted(fogcomp::recording::Recording recording, double dph) {
  for (double& rate : recording.rate_dph) rate += dph;
  return recording;
}

double rms_left_dph(const fogcomp::model::Model& model,
                    const fogcomp::recording::Recording& recording,
                    const std::vector<fogcomp::recording::Cut>& cuts = {}) {
  fogcomp::runs::Run run = fogcomp::runs::run_of(recording, {model.average_s});
  for (const fogcomp::recording::Cut& cut : cuts) fogcomp::runs::set_cut(run, cut, true);
  return fogcomp::compare::compare_with(model, run, model.average_s).whole.rms_dph;
}

TEST(Cuts, AJumpAtACut_LeavesTheEffectsAlone) {
  const FittedWithCuts with = fit_with_cuts({recording_with_jump(5)}, {kAt_s});
  const FittedWithCuts clean = fit_with_cuts({noisy_recording(5)}, {});
  ASSERT_EQ(with.identified.run_offsets_dph.size(), 1U);
  EXPECT_NEAR(with.identified.run_offsets_dph[0], kJump_dph, 0.02);
  const auto& rate = with.model.terms[2].coefficients_dph[0];
  EXPECT_NEAR(rate.value, clean.model.terms[2].coefficients_dph[0].value, rate.sigma);
}

TEST(Cuts, TheRowOfACutAndTheNearerNeighbour_DoNotCount) {
  const FittedWithCuts fitted = fit_with_cuts({recording_with_jump(5)}, {kAt_s});
  EXPECT_EQ(fitted.identified.masked, 2U);
}

TEST(Cuts, TheBiasOfTheModel_IsThatAfterTheLastCut) {
  fogcomp::recording::Recording recording = recording_with_jump(5);
  add_step(recording, 27000, -0.3);
  const FittedWithCuts fitted = fit_with_cuts({recording}, {kAt_s, 27000});
  EXPECT_LT(rms_left_dph(fitted.model, shifted(noisy_recording(6), kJump_dph - 0.3)),
            kLittleAboveNoise_dph);
}

TEST(Cuts, TheBiasOfTheModel_IsTheMeanOfThoseWithWhichTheRunsEnd) {
  const FittedWithCuts fitted =
      fit_with_cuts({recording_with_jump(5), noisy_recording(4)}, {kAt_s});
  EXPECT_LT(rms_left_dph(fitted.model, shifted(noisy_recording(6), kJump_dph / 2)),
            kLittleAboveNoise_dph);
}

TEST(Cuts, ACutRun_IsComparedWithABiasForEachPart) {
  const FittedWithCuts fitted = fit_with_cuts({recording_with_jump(5)}, {kAt_s});
  EXPECT_LT(rms_left_dph(fitted.model, recording_with_jump(5), {{"", kAt_s}}),
            kLittleAboveNoise_dph);
  EXPECT_GT(rms_left_dph(fitted.model, recording_with_jump(5)), kJump_dph / 2);
}

}  // namespace
