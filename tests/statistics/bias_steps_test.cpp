// Detection rate of steps, and false alarms without steps.
#include <gtest/gtest.h>

#include "unit/fit/recording_with_steps.hpp"

namespace {

using namespace fog::test;

TEST(FoundSteps, AreNoneInWhiteAndFlickerNoise) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const FittedSteps result = fit({noisy_recording(seed)}, kStepEffects);
    found += result.identified.steps.empty() ? 0 : 1;
  }
  std::printf("steps found in %d of 100 recordings without one\n", found);
  EXPECT_LE(found, 2);
}

TEST(FoundSteps, OfFiveSigmaOfARowAreWithinAFewRows) {
  int found = 0;
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    fogcomp::recording::Recording recording = noisy_recording(seed);
    const double at_s = 4000 + 1300 * static_cast<double>(seed);
    const double size_dph = (seed % 2 == 0 ? 5 : -5) * kWhiteDph;
    add_step(recording, at_s, size_dph);
    const FittedSteps result = fit({recording}, kStepEffects);
    if (result.identified.steps.size() != 1) continue;
    ++found;
    const fogcomp::fit::FoundStep& step = result.identified.steps[0];
    EXPECT_NEAR(step.time_s, at_s, 30) << seed;
    EXPECT_LT(step.time_sigma_s, 20) << seed;
    covered += std::abs(step.size_dph - size_dph) <= 1.96 * step.size_sigma_dph ? 1 : 0;
    EXPECT_GE(result.identified.masked, 1U);
    // The step becomes a term of the model, and the others are as without it.
    EXPECT_STREQ(result.model.terms.back().name.c_str(), "bias_step");
    EXPECT_EQ(result.model.terms.back().parameters[0].value, step.time_s);
    EXPECT_NEAR(result.model.terms[2].coefficients_dph[0].value,
                truth().terms[2].coefficients_dph[0].value,
                4 * result.model.terms[2].coefficients_dph[0].sigma);
  }
  std::printf("found %d of 20; the size within its 95 %% interval in %d\n", found, covered);
  EXPECT_GE(found, 19);
  EXPECT_GE(covered, 16);
}

}  // namespace
