#include "compare/residual_analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::compare {
namespace {

using model::Model;

constexpr fog::test::RowNoise kNoise{0.024, 0.006, 300};

Model truth() {
  Model model = fog::test::paper_like_model();
  model.network = {};
  return model;
}

Comparison compare(const Model& model, std::uint64_t seed) {
  return compare_with(model, runs::run_of(fog::test::recording_of(truth(), kNoise, seed), {10}),
                      10);
}

// The true model leaves white and slow noise, whose size the analysis estimates in the soaks.
TEST(ResidualAnalysis, FindsLittleWhereOnlyNoiseIsLeft) {
  constexpr int kSeeds = 100;
  int temperature = 0;
  int rate = 0;
  int history = 0;
  int offset = 0;
  int time = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const ResidualAnalysis found =
        analyse_residual(compare(truth(), static_cast<std::uint64_t>(seed)));
    if (found.temperature.test.structured()) ++temperature;
    if (found.rate.test.structured()) ++rate;
    if (found.history.test.structured()) ++history;
    if (found.offset.structured()) ++offset;
    if (found.time.test.structured()) ++time;
  }
  std::printf("falsely structured of %d: temperature %d, rate %d, history %d, offset %d, time %d\n",
              kSeeds, temperature, rate, history, offset, time);
  EXPECT_LE(temperature, 4);
  EXPECT_LE(rate, 4);
  EXPECT_LE(history, 4);
  EXPECT_LE(offset, 4);
  EXPECT_LE(time, 15);
}

TEST(ResidualAnalysis, NamesTheRateWhereItsTermIsMissing) {
  Model model = truth();
  model.terms[2].coefficients_dph = {0};
  const auto comparison = compare(model, 1);
  const ResidualAnalysis found = analyse_residual(comparison);
  EXPECT_TRUE(found.rate.test.structured());
  ASSERT_TRUE(found.share_of_excess(found.rate.test).has_value());
  EXPECT_GT(*found.share_of_excess(found.rate.test), 0.8);
  EXPECT_TRUE(found.history.test.structured());
  // The bins of the rate follow the missing line: 0.44 of the coefficient's unit, 4 degC/min.
  for (const auto& bin : found.rate.bins) {
    EXPECT_NEAR(bin.mean_dph, 0.44 * bin.at / 4, 5 * bin.sigma_dph);
  }
}

TEST(ResidualAnalysis, KnowsAnOffsetFromDrift) {
  Model model = truth();
  model.terms[0].coefficients_dph[0].value -= 0.02;
  const ResidualAnalysis found = analyse_residual(compare(model, 1));
  EXPECT_TRUE(found.offset.structured());
  EXPECT_GT(found.share_of_excess(found.offset).value_or(0), 0.7);
  EXPECT_FALSE(found.temperature.test.structured());
}

// Soaks are 360 rows each; the model changes nothing in them but the mean.
TEST(ResidualAnalysis, TakesAllanDeviationsInSoaksOnly) {
  const ResidualAnalysis found = analyse_residual(compare(truth(), 1));
  ASSERT_FALSE(found.raw_allan.empty());
  ASSERT_EQ(found.raw_allan.size(), found.residual_allan.size());
  EXPECT_NEAR(found.residual_allan[0].sigma, 0.024, 0.002);
  EXPECT_LE(found.raw_allan.back().tau_s, 3600);
}

TEST(ResidualAnalysis, OfOneRowShowsNothing) {
  recording::Recording recording = fog::test::recording_of(truth(), kNoise, 1);
  for (auto* column : {&recording.time_s, &recording.temperature_degc, &recording.rate_dph}) {
    column->resize(1);
  }
  const auto comparison = compare_with(truth(), runs::run_of(recording, {10}), 10);
  const ResidualAnalysis found = analyse_residual(comparison);
  EXPECT_TRUE(found.temperature.bins.empty());
  EXPECT_EQ(found.history.widest(), nullptr);
  EXPECT_FALSE(found.excess_dph2.has_value());
  EXPECT_TRUE(found.raw_allan.empty());
}

}  // namespace
}  // namespace fogcomp::compare
