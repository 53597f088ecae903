#include "noise/allan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace fogcomp::noise {
namespace {

std::vector<double> white(std::size_t size) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(100, 1);
  std::vector<double> values(size);
  for (double& value : values) value = normal(random);
  return values;
}

/// The definition, word for word: all pairs of neighbouring means of m samples.
double by_definition(const std::vector<double>& values,
                     const std::vector<recording::RowRange>& ranges, std::size_t m) {
  double sum = 0;
  double count = 0;
  for (const recording::RowRange& range : ranges) {
    for (std::size_t i = range.first; i + 2 * m <= range.end; ++i) {
      double first = 0;
      double second = 0;
      for (std::size_t j = 0; j < m; ++j) {
        first += values[i + j];
        second += values[i + m + j];
      }
      sum += std::pow((second - first) / static_cast<double>(m), 2);
      ++count;
    }
  }
  return std::sqrt(sum / count / 2);
}

TEST(Allan, IsTheOverlappingDefinitionAtEveryOctave) {
  const std::vector<double> values = white(5000);
  const std::vector<recording::RowRange> ranges{{0, 5000}};
  const auto points = allan_deviation(values, ranges, 0.5);
  ASSERT_EQ(points.size(), 11U);  // 1024 samples fit almost five times, 2048 less than three
  for (const AllanPoint& point : points) {
    EXPECT_EQ(point.tau_s, 0.5 * static_cast<double>(point.samples));
    EXPECT_NEAR(point.sigma, by_definition(values, ranges, point.samples), 1e-12);
    const double n_over_m = 5000.0 / static_cast<double>(point.samples);
    EXPECT_NEAR(point.one_sigma, point.sigma / std::sqrt(2 * (n_over_m - 1)), 1e-12);
  }
}

TEST(Allan, PoolsRangesWithoutCrossingTheirEnds) {
  std::vector<double> values = white(3000);
  for (std::size_t i = 1700; i < 3000; ++i) values[i] += 1000;  // a step that must not be seen
  const std::vector<recording::RowRange> ranges{{0, 700}, {700, 1700}, {1700, 1701}, {1800, 2900}};
  for (const AllanPoint& point : allan_deviation(values, ranges, 1)) {
    EXPECT_NEAR(point.sigma, by_definition(values, ranges, point.samples), 1e-9);
  }
}

TEST(Allan, HasNoPointsWhereNothingCanBeCompared) {
  EXPECT_TRUE(allan_deviation({}, {}, 1).empty());
  EXPECT_TRUE(allan_deviation({1, 2}, {{0, 1}, {1, 2}}, 1).empty());
}

TEST(Allan, LooksAtSoaksOnlyAndNotAcrossGaps) {
  recording::Recording recording;
  recording.time_s.resize(100);
  recording.stretch_starts = {0, 20, 60};
  const std::vector<recording::Segment> segments{
      {"a", recording::SegmentKind::soak, 0, 0, {0, 40}},
      {"b", recording::SegmentKind::ramp_up, 0, 0, {40, 70}},
      {"c", recording::SegmentKind::soak, 0, 0, {70, 100}}};
  const auto ranges = soak_ranges(recording, segments);
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_EQ(ranges[1].first, 20U);
  EXPECT_EQ(ranges[1].end, 40U);
  EXPECT_EQ(ranges[2].first, 70U);
}

}  // namespace
}  // namespace fogcomp::noise
