// A drift that is linear in time is no effect, but is told, with an uncertainty that covers slow
// noise.

#include "diagnosis/line_in_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/ladder.hpp"
#include "diagnosis/model_fit.hpp"
#include "unit/fit/recording_with_steps.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kSlope_dphh = 0.01;
constexpr std::uint64_t kSeeds = 8;

recording::Recording drifting(recording::Recording recording, double slope_dphh) {
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.rate_dph[i] += slope_dphh * recording.time_s[i] / 3600;
  }
  return recording;
}

std::optional<LineInTime> line_of(const recording::Recording& recording, const std::string& more) {
  model::Model model = fog::test::truth();
  model.terms = model::parse_effects("bias,bias_temperature:order=3,temperature_rate" + more);
  DiagnosisData data(model, {runs::run_of(recording, {model.average_s})});
  return find_line_in_time(data, fit_for_diagnosis(model, data, std::nullopt));
}

// Standard deviation of the slope of white noise alone over ten hours of rows.
double white_sigma_dphh(const recording::Recording& recording) {
  const double hours = recording.time_s.back() / 3600;
  return fog::test::kWhiteDph * std::sqrt(12.0 / static_cast<double>(recording.rows())) / hours;
}

// Flicker over hours looks like a slope: white noise alone would have a fifth of the uncertainty.
TEST(LineInTime, HasTheUncertaintyOfTheSlowNoise) {
  double square = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const recording::Recording recording = drifting(fog::test::noisy_recording(seed), kSlope_dphh);
    const std::optional<LineInTime> line = line_of(recording, "");
    ASSERT_TRUE(line);
    EXPECT_TRUE(line->is_significant()) << seed;
    EXPECT_GT(line->sigma_dphh, 3 * white_sigma_dphh(recording)) << seed;
    square += std::pow((line->slope_dphh - kSlope_dphh) / line->sigma_dphh, 2);
  }
  EXPECT_LT(square / kSeeds, 2.5);  // 1 on average
  EXPECT_GT(square / kSeeds, 0.1);  // the noise made here has its slowest part at two hours
}

TEST(LineInTime, IsNotSignificantWithoutADrift) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::optional<LineInTime> line = line_of(fog::test::noisy_recording(seed), "");
    ASSERT_TRUE(line);
    EXPECT_FALSE(line->is_significant())
        << seed << ": " << line->slope_dphh << " +- " << line->sigma_dphh;
  }
}

TEST(LineInTime, IsSignificantFromTheOnePercentLevelOn) {
  EXPECT_TRUE((LineInTime{-2.59, 1}.is_significant()));
  EXPECT_FALSE((LineInTime{2.56, 1}.is_significant()));
}

// Through the whole diagnosis. `runs`: drifts of the recordings.
Ladder ladder_of(const std::vector<double>& slopes_dphh) {
  model::Model model = fog::test::truth();
  runs::Runs runs;
  for (std::size_t i = 0; i < slopes_dphh.size(); ++i) {
    const recording::Recording recording =
        fog::test::recording_of(model, fog::test::kQuietNoise, 1 + i);
    runs.training.push_back(runs::run_of(fog::test::thinned(drifting(recording, slopes_dphh[i]), 3),
                                         {model.average_s}));
  }
  return stepwise_selection(model, {model, runs.training}, runs, 0, {});
}

TEST(LineInTime, IsToldWhereAgeingIsRefusedForIt) {
  constexpr double kClear_dphh = 0.1;  // more than a random walk does
  const Ladder ladder = ladder_of({kClear_dphh});
  EXPECT_FALSE(ladder.next.addition);
  EXPECT_TRUE(ladder.next.refused_line());
  ASSERT_TRUE(ladder.first.line);
  EXPECT_NEAR(ladder.first.line->slope_dphh, kClear_dphh, 3 * ladder.first.line->sigma_dphh);
  EXPECT_FALSE(ladder_of({0}).first.line);
  EXPECT_FALSE(ladder_of({kClear_dphh, kClear_dphh}).first.line);  // two runs tell by themselves
}

}  // namespace
}  // namespace fogcomp::diagnosis
