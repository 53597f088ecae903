#include "compare/run_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace fogcomp::compare {
namespace {

/// One row a second at a constant temperature.
recording::Recording record(const std::vector<double>& rate_dph) {
  recording::Recording recording;
  recording.period_s = rate_dph.size() > 1 ? 1 : 0;
  recording.rate_dph = rate_dph;
  for (std::size_t i = 0; i < rate_dph.size(); ++i) {
    recording.time_s.push_back(static_cast<double>(i));
    recording.temperature_degc.push_back(20);
  }
  recording.stretch_starts = {0};
  return recording;
}

TEST(RunSummary, TakesMeanFromSamplesAndStdFromRows) {
  recording::Recording recording = record({1, 3, 5, 7, 9, 11, 100});
  recording.input_rate_dph.assign(7, 1);
  const RunSummary summary = summarize(recording, 2);
  EXPECT_DOUBLE_EQ(summary.bias.mean_dph, 136.0 / 7 - 1);
  EXPECT_DOUBLE_EQ(summary.bias.std_dph.value_or(0),
                   4);  // of 2, 6, 10: the bias is rate less input
  EXPECT_EQ(summary.average_s, 2);
  ASSERT_EQ(summary.segments.size(), 1U);
  EXPECT_EQ(summary.segments[0].duration_s, 7);
  EXPECT_EQ(summary.soak_s, 7);
}

TEST(RunSummary, LeavesOutWhatIsMasked) {
  std::vector<double> rates(1000);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = i % 2 == 0 ? 0.9 : 1.1;
  for (std::size_t i = 500; i < 504; ++i) rates[i] = 500;  // a flank that a slow record lacks
  recording::Recording recording = record(rates);
  recording.masks.push_back({"", 500, 503});
  const RunSummary summary = summarize(recording, 10);
  EXPECT_NEAR(summary.bias.mean_dph, 1, 1e-3);
  EXPECT_LT(summary.bias.std_dph.value_or(1), 0.02);
  EXPECT_LT(summary.bias.sample_std_dph.value_or(1), 0.11);
  EXPECT_EQ(summary.outliers, 0U);
}

TEST(RunSummary, OfOneRowHasAMeanAndNothingElse) {
  const RunSummary summary = summarize(record({0.5}), 10);
  EXPECT_EQ(summary.bias.mean_dph, 0.5);
  EXPECT_FALSE(summary.bias.std_dph.has_value());
  EXPECT_FALSE(summary.noise_floor_dph.has_value());
  EXPECT_TRUE(summary.allan.empty());
  EXPECT_EQ(summary.segments.size(), 1U);
}

TEST(RunSummary, HasNoAllanDeviationWithoutSoak) {
  recording::Recording recording = record(std::vector<double>(3600, 0.5));
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.temperature_degc[i] = static_cast<double>(i) / 60;
  }
  EXPECT_TRUE(summarize(recording, 10).allan.empty());
}

TEST(RunSummary, StandsAnyShapeOfRecording) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 500; ++round) {
    const std::size_t rows = 1 + random() % 60;
    recording::Recording recording = record(std::vector<double>(rows, 0));
    double time_s = 0;
    double temperature_degc = 20;
    for (std::size_t i = 0; i < rows; ++i) {
      const bool gap = i > 0 && random() % 10 == 0;
      time_s += gap ? 1.0 + static_cast<double>(random() % 100) : 1.0;
      if (gap) recording.stretch_starts.push_back(i);
      temperature_degc += 3 * normal(random);
      recording.time_s[i] = time_s;
      recording.temperature_degc[i] = temperature_degc;
      recording.rate_dph[i] = normal(random);
    }
    const RunSummary summary = summarize(recording, 1 + static_cast<double>(random() % 20));
    std::size_t covered = 0;
    for (const SegmentSummary& segment : summary.segments) covered += segment.rows;
    EXPECT_EQ(covered, rows);
    EXPECT_TRUE(std::isfinite(summary.bias.mean_dph));
  }
}

}  // namespace
}  // namespace fogcomp::compare
