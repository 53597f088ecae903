#include "recording/segments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

struct Chamber {
  double ramp_degc_per_min = 0.5;
  double soak_min = 120;
  std::vector<double> levels_degc{20, -40, 60, 20};
  double lag_min = 0;          ///< first-order lag of what the sensor sees
  double noise_degc = 0;       ///< white, of each sample
  double resolution_degc = 0;  ///< of the sensor
  double period_s = 1;
};

/// Recording of a sensor in the chamber.
Recording record(const Chamber& chamber) {
  Recording recording;
  recording.period_s = chamber.period_s;
  recording.stretch_starts = {0};
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  double sensor = chamber.levels_degc[0];
  const auto hold = [&](double from, double to, double minutes) {
    const auto rows = static_cast<std::size_t>(minutes * 60 / chamber.period_s);
    for (std::size_t i = 0; i < rows; ++i) {
      const double air = from + (to - from) * static_cast<double>(i) / static_cast<double>(rows);
      sensor = chamber.lag_min > 0
                   ? sensor + (air - sensor) * chamber.period_s / 60 / chamber.lag_min
                   : air;
      double seen = sensor + chamber.noise_degc * noise(random);
      if (chamber.resolution_degc > 0) {
        seen = std::round(seen / chamber.resolution_degc) * chamber.resolution_degc;
      }
      recording.time_s.push_back(static_cast<double>(recording.rows()) * chamber.period_s);
      recording.temperature_degc.push_back(seen);
    }
  };
  for (std::size_t i = 0; i < chamber.levels_degc.size(); ++i) {
    const double level = chamber.levels_degc[i];
    if (i > 0) {
      const double from = chamber.levels_degc[i - 1];
      hold(from, level, std::fabs(level - from) / chamber.ramp_degc_per_min);
    }
    hold(level, level, chamber.soak_min);
  }
  return recording;
}

std::vector<std::string> names(const Recording& recording) {
  std::vector<std::string> result;
  for (const Segment& segment : find_segments(recording)) result.push_back(segment.name);
  return result;
}

const std::vector<std::string> kPaperSegments{
    "soak 20", "ramp 20..-40", "soak -40", "ramp -40..60", "soak 60", "ramp 60..20", "soak 20 (2)"};

void expect_to_cover_all_rows(const Recording& recording) {
  std::size_t next = 0;
  for (const Segment& segment : find_segments(recording)) {
    EXPECT_EQ(segment.rows.first, next);
    EXPECT_GT(segment.rows.end, segment.rows.first);
    next = segment.rows.end;
  }
  EXPECT_EQ(next, recording.rows());
}

TEST(Segments, FindThePapersProgramme) {
  Chamber chamber;
  chamber.noise_degc = 0.01;
  const Recording recording = record(chamber);
  const std::vector<Segment> segments = find_segments(recording);
  EXPECT_EQ(names(recording), kPaperSegments);
  expect_to_cover_all_rows(recording);
  // Corners to within the time in which the ramp covers the tolerance.
  EXPECT_NEAR(recording.time_s[segments[1].rows.first], 120 * 60, 60);
  EXPECT_NEAR(recording.time_s[segments[2].rows.first], 240 * 60, 60);
  EXPECT_EQ(segments[1].kind, SegmentKind::ramp_down);
  EXPECT_EQ(segments[3].kind, SegmentKind::ramp_up);
}

TEST(Segments, FindRampsOfEverySpeed) {
  for (const double speed : {0.1, 0.3, 1.0, 3.0, 10.0}) {
    Chamber chamber;
    chamber.ramp_degc_per_min = speed;
    chamber.soak_min = 15;
    chamber.noise_degc = 0.02;
    EXPECT_EQ(names(record(chamber)), kPaperSegments) << speed << " degC/min";
  }
}

// A soak stands, however slowly a ramp goes.
TEST(Segments, SlowRamp_IsNoSoak) {
  for (const double speed : {0.014, 0.03}) {
    Chamber chamber;
    chamber.levels_degc = {10, 50};
    chamber.ramp_degc_per_min = speed;
    chamber.soak_min = 0;
    chamber.period_s = 10;
    chamber.noise_degc = 0.02;
    EXPECT_EQ(names(record(chamber)), std::vector<std::string>{"ramp 10..50"}) << speed;
  }
  Chamber room;
  room.levels_degc = {20, 21.5, 20};
  room.ramp_degc_per_min = 0.02;
  EXPECT_EQ(names(record(room)).size(), 1U);
}

TEST(Segments, AreNotMadeByNoiseOrStepsOfTheSensor) {
  for (const double resolution : {0.01, 0.0625, 0.5, 1.0}) {
    for (const double noise : {0.0, 0.05, 0.3}) {
      Chamber chamber;
      chamber.resolution_degc = resolution;
      chamber.noise_degc = noise;
      EXPECT_EQ(names(record(chamber)), kPaperSegments) << resolution << ", noise " << noise;
    }
  }
}

TEST(Segments, CountTheTailOfTheChamberToTheRamp) {
  Chamber chamber;
  chamber.lag_min = 16;
  chamber.noise_degc = 0.005;
  const Recording recording = record(chamber);
  EXPECT_EQ(names(recording), kPaperSegments);
  for (const Segment& segment : find_segments(recording)) {
    if (segment.kind != SegmentKind::soak) continue;
    const double start = recording.temperature_degc[segment.rows.first];
    const double end = recording.temperature_degc[segment.rows.end - 1];
    EXPECT_NEAR(start, end, 0.8) << segment.name;
  }
}

TEST(Segments, AreOneSoakForOneRowOrAConstantTemperature) {
  Recording recording;
  recording.time_s = {5};
  recording.temperature_degc = {-0.4};
  recording.stretch_starts = {0};
  EXPECT_EQ(names(recording), std::vector<std::string>{"soak 0"});

  Chamber chamber;
  chamber.levels_degc = {35};
  EXPECT_EQ(names(record(chamber)), std::vector<std::string>{"soak 35"});
}

TEST(Segments, AreOneRampForARecordingThatNeverRests) {
  Chamber chamber;
  chamber.levels_degc = {-40, 60};
  chamber.soak_min = 0;
  EXPECT_EQ(names(record(chamber)), std::vector<std::string>{"ramp -40..60"});
}

TEST(Segments, StartAnewAfterAGapButNotAfterALostSample) {
  Chamber chamber;
  chamber.levels_degc = {20};
  chamber.soak_min = 10;
  chamber.period_s = 0.1;
  Recording recording = record(chamber);
  const auto pause = [&](std::size_t row, double gap_s) {
    for (std::size_t i = row; i < recording.rows(); ++i) recording.time_s[i] += gap_s;
    recording.stretch_starts.push_back(row);
  };
  pause(1000, 0.1);
  pause(2000, 5);
  pause(4000, 3600);
  const std::vector<Segment> segments = find_segments(recording);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[1].rows.first, 2000U);
  EXPECT_EQ(segments[2].rows.first, 4000U);
  EXPECT_EQ(segments[2].name, "soak 20 (3)");
}

TEST(Segments, FollowTheSegmentColumn) {
  Chamber chamber;
  chamber.levels_degc = {20, 60};
  chamber.soak_min = 30;
  Recording recording = record(chamber);
  recording.labels = {{10, "a"}, {2000, "b"}, {5000, "a"}};
  const std::vector<Segment> segments = find_segments(recording);
  EXPECT_EQ(names(recording), (std::vector<std::string>{"unlabelled", "a", "b", "a (2)"}));
  EXPECT_EQ(segments[1].kind, SegmentKind::soak);
  EXPECT_EQ(segments[2].kind, SegmentKind::ramp_up);
  expect_to_cover_all_rows(recording);
}

TEST(Segments, StretchesEndAtGapsAndMasks) {
  Recording recording;
  for (int i = 0; i < 20; ++i) recording.time_s.push_back(i);
  recording.stretch_starts = {0, 10};
  recording.masks = {{"", -1, 1}, {"", 5, 6.5}, {"", 9.5, 12}};
  const std::vector<RowRange> stretches = unmasked_stretches(recording);
  ASSERT_EQ(stretches.size(), 3U);
  const std::size_t expected[][2] = {{2, 5}, {7, 10}, {13, 20}};
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    EXPECT_EQ(stretches[i].first, expected[i][0]);
    EXPECT_EQ(stretches[i].end, expected[i][1]);
  }
}

TEST(Segments, SplitARealMemsChamberCycleAtItsTurningPoints) {
  const std::string path = FOG_SOURCE_DIR "/../shared/data/mems_chamber_x.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "skipped: no recording";
  const Recording recording = read_recording(path, {});
  const std::vector<Segment> segments = find_segments(recording);
  ASSERT_GE(segments.size(), 3U);
  EXPECT_EQ(segments[0].name, "ramp 52..-18");
  EXPECT_EQ(segments[1].name, "ramp -18..74");
  EXPECT_EQ(segments[2].kind, SegmentKind::ramp_down);
  expect_to_cover_all_rows(recording);
}

}  // namespace
}  // namespace fogcomp::recording
