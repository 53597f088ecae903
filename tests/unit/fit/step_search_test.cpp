#include "fit/step_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/fit/recording_with_steps.hpp"

namespace fogcomp::fit {
namespace {

FitWithSteps searched(
    const recording::Recording& recording,
    const std::string& effects = "bias,bias_temperature:order=3,temperature_rate") {
  const model::Model model = fog::test::truth();
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  return fit_with_steps(series, model::parse_effects(effects),
                        Eigen::MatrixXd(series.rows().size(), 0), 8, {});
}

TEST(StepSearch, FindsAStepWithItsTimeAndSize) {
  recording::Recording recording = fog::test::noisy_recording(2);
  fog::test::add_step(recording, 20000, 0.2);
  const FitWithSteps result = searched(recording);
  ASSERT_EQ(result.steps.size(), 1U);
  const noise::ChangePoint& step = result.steps[0].change;
  EXPECT_NEAR(step.time_s, 20000, 30);
  EXPECT_NEAR(step.size_dph, 0.2, 4 * step.size_sigma_dph);
  EXPECT_LE(step.first, step.row);
  EXPECT_GE(step.last, step.row);
  // Its column is the last one of the fit, and the bias is the one that follows.
  const auto& fit = result.fit;
  EXPECT_NEAR(fit.coefficients[fit.linear() - 1], 0.2, 4 * step.size_sigma_dph);
  EXPECT_NEAR(fit.coefficients[0], fog::test::truth().terms[0].coefficients_dph[0].value + 0.2,
              0.02);
  EXPECT_EQ(result.masked, static_cast<std::size_t>(step.last - step.first + 1));
}

// As a fit in rows of another length takes those that were found.
TEST(StepSearch, TakesKnownSteps) {
  recording::Recording recording = fog::test::noisy_recording(2);
  fog::test::add_step(recording, 20000, 0.2);
  model::Model model = fog::test::truth();
  model.average_s = 40;
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  const FitWithSteps result =
      fit_at_steps(series, model.terms, Eigen::MatrixXd(series.rows().size(), 0),
                   {{0, 20000, 5, 0, 0, true}}, {});
  ASSERT_EQ(result.steps.size(), 1U);
  EXPECT_EQ(result.steps[0].change.time_s, 20000);
  EXPECT_EQ(result.masked, 2U);  // both may hold a part of it
  const auto& fit = result.fit;
  EXPECT_NEAR(fit.coefficients[fit.linear() - 1], 0.2, 0.02);
  EXPECT_NEAR(fit.coefficients[0], fog::test::truth().terms[0].coefficients_dph[0].value + 0.2,
              0.02);
}

// Drift over hours that no effect of the model describes.
TEST(StepSearch, TakesSlowDriftForNoStep) {
  recording::Recording recording = fog::test::noisy_recording(3);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.rate_dph[i] += 0.2 * std::sin(recording.time_s[i] / 6000);
  }
  EXPECT_TRUE(searched(recording).steps.empty());
}

// Faster than the drift that the search allows for anyway, and no jump.
TEST(StepSearch, TakesAChangeOverMinutesForNoStep) {
  recording::Recording recording = fog::test::noisy_recording(5);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.rate_dph[i] += 0.4 * std::clamp((recording.time_s[i] - 20000) / 400, 0.0, 1.0);
  }
  EXPECT_TRUE(searched(recording).steps.empty());
}

TEST(StepSearch, StopsAtEight) {
  recording::Recording recording = fog::test::noisy_recording(4);
  for (int i = 1; i <= 12; ++i) fog::test::add_step(recording, 2700 * i, i % 2 == 0 ? 0.5 : -0.5);
  const std::size_t found = searched(recording).steps.size();
  EXPECT_LE(found, 8U);
  EXPECT_GE(found, 5U);
}

}  // namespace
}  // namespace fogcomp::fit
