#include "runs/runs.hpp"

#include <gtest/gtest.h>

#include "series/signal_series.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::runs {
namespace {

using fog::test::kQuietNoise;
using fog::test::recording_of;

recording::Recording whole() {
  return recording_of(fog::test::truth(), kQuietNoise, 1);
}

// Rows `first` to `end` of `run`, as a separate file.
recording::Recording part(const recording::Recording& run, std::ptrdiff_t first, std::ptrdiff_t end,
                          const std::string& file) {
  recording::Recording part = run;
  part.file = file;
  const auto cut = [&](std::vector<double>& column) {
    if (!column.empty()) column = {column.begin() + first, column.begin() + end};
  };
  cut(part.time_s);
  cut(part.temperature_degc);
  cut(part.rate_dph);
  cut(part.input_rate_dph);
  return part;
}

std::vector<runs::Run> in_blocks(const std::vector<recording::Recording>& recordings) {
  std::vector<runs::Run> runs;
  for (const recording::Recording& one : recordings) runs.push_back(run_of(one, {10}));
  return runs;
}

// What a fit sees of runs.
series::Rows rows_of(const std::vector<runs::Run>& runs) {
  static const model::Model model = fog::test::truth();
  series::SignalSeries series(model);
  for (const Run& run : runs) series.add(run.blocks);
  return series.rows();
}

TEST(JoinedRuns, AreTheRunThatWasCutIntoFilesInAnyOrder) {
  const recording::Recording run = whole();
  const auto rows = static_cast<std::ptrdiff_t>(run.rows());
  const recording::Recording a = part(run, 0, 500, "a.csv");
  const recording::Recording b = part(run, 500, 1700, "b.csv");
  const recording::Recording c = part(run, 1700, rows, "c.csv");
  const series::Rows expected = rows_of(in_blocks({run}));
  for (const auto& files : {std::vector{a, b, c}, {c, b, a}, {b, a, c}, {b, c, a}}) {
    const auto [joined, notes] = join_continued(in_blocks(files));
    ASSERT_EQ(joined.size(), 1U);
    EXPECT_EQ(joined[0].file, "a.csv + b.csv + c.csv");
    EXPECT_EQ(joined[0].files, (std::vector<std::string>{"a.csv", "b.csv", "c.csv"}));
    EXPECT_EQ(joined[0].blocks.recordings.size(), 3U);
    EXPECT_EQ(notes.size(), 2U);
    const series::Rows seen = rows_of(joined);
    EXPECT_EQ(seen.time_s, expected.time_s);
    EXPECT_EQ(seen.drift_dph, expected.drift_dph);
    EXPECT_EQ(seen.run_starts, expected.run_starts);
    for (std::size_t i = 0; i < seen.signals.size(); ++i) {
      ASSERT_EQ(seen.signals[i].temperature_rate, expected.signals[i].temperature_rate) << i;
    }
  }
}

// A logger's clock may be faster in one hour than in the next.
TEST(JoinedRuns, HaveTheMeanPeriodOfTheirFiles) {
  const recording::Recording run = whole();
  const auto rows = static_cast<std::ptrdiff_t>(run.rows());
  recording::Recording a = part(run, 0, rows / 4, "a.csv");
  recording::Recording b = part(run, rows / 4, rows, "b.csv");
  a.period_s = 1.004 * run.period_s;
  b.period_s = run.period_s;
  for (const auto& files : {std::vector{a, b}, {b, a}}) {
    const std::vector<runs::Run> joined = join_continued(in_blocks(files)).runs;
    ASSERT_EQ(joined.size(), 1U);
    EXPECT_NEAR(joined[0].blocks.period_s, 1.001 * run.period_s, 1e-5 * run.period_s);
    EXPECT_EQ(joined[0].blocks.block_s,
              joined[0].blocks.period_s * joined[0].blocks.samples_per_block);
  }
}

TEST(JoinedRuns, HaveSegmentsWithNamesOfTheirOwn) {
  const recording::Recording run = whole();
  const auto rows = static_cast<std::ptrdiff_t>(run.rows());
  // In the middle of the first soak, and of the first ramp.
  const runs::Run joined =
      join_continued(in_blocks({part(run, 0, 180, "a.csv"), part(run, 180, 620, "b.csv"),
                                part(run, 620, rows, "c.csv")}))
          .runs[0];
  ASSERT_GT(joined.segments.size(), 3U);
  EXPECT_EQ(joined.segments[0].name, "soak 20");
  EXPECT_EQ(joined.segments[1].kind, recording::SegmentKind::ramp_down);
  for (std::size_t i = 1; i < joined.segments.size(); ++i) {
    EXPECT_GE(joined.segments[i].start_s, joined.segments[i - 1].start_s);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(joined.segments[i].name, joined.segments[j].name);
  }
}

TEST(JoinedRuns, LeaveApartWhatBeginsAnewOrLater) {
  const recording::Recording run = whole();
  const auto rows = static_cast<std::ptrdiff_t>(run.rows());
  const recording::Recording a = part(run, 0, 500, "a.csv");
  recording::Recording again = recording_of(fog::test::truth(), kQuietNoise, 2);  // from power-on
  recording::Recording later = part(run, 510, rows, "later.csv");
  recording::Recording other = part(run, 500, rows, "other.csv");
  other[fog::Input::magnetic].assign(other.rows(), 1.0);
  for (const recording::Recording& second : {again, later, other}) {
    const auto [joined, notes] = join_continued(in_blocks({a, second}));
    EXPECT_EQ(joined.size(), 2U) << second.file;
    EXPECT_TRUE(notes.empty()) << second.file;
  }
}

}  // namespace
}  // namespace fogcomp::runs
