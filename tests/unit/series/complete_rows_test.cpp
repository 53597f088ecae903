#include "series/complete_rows.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::series {
namespace {

/// Row i at i * 0.5 s with temperature i and rate 10 i; gaps before the rows of `starts`.
recording::Recording counting(std::size_t samples, std::vector<std::size_t> starts = {0}) {
  recording::Recording recording;
  recording.period_s = 0.5;
  for (std::size_t i = 0; i < samples; ++i) {
    recording.time_s.push_back(static_cast<double>(i) * 0.5);
    recording.temperature_degc.push_back(static_cast<double>(i));
    recording.rate_dph.push_back(static_cast<double>(10 * i));
  }
  recording.stretch_starts = std::move(starts);
  return recording;
}

TEST(CompleteRows, AreMeansAroundTheirCentre) {
  recording::Recording recording = counting(9);
  recording.input_rate_dph.assign(9, 0.1);
  const CompleteRows rows = complete_rows(recording, 2);
  EXPECT_EQ(rows.samples_per_row, 4U);
  EXPECT_EQ(rows.means.period_s, 2);
  EXPECT_EQ(rows.means.time_s, (std::vector<double>{0.75, 2.75}));
  EXPECT_EQ(rows.means.temperature_degc, (std::vector<double>{1.5, 5.5}));
  EXPECT_EQ(rows.means.rate_dph, (std::vector<double>{15, 55}));
  EXPECT_EQ(rows.means.input_rate_dph, (std::vector<double>{0.1, 0.1}));
  EXPECT_TRUE(rows.means[fog::Input::supply].empty());
}

TEST(CompleteRows, NeverCrossAGap) {
  const CompleteRows rows = complete_rows(counting(20, {0, 7, 8, 12}), 2);
  EXPECT_EQ(rows.first_samples, (std::vector<std::size_t>{0, 8, 12, 16}));
  EXPECT_EQ(rows.means.stretch_starts, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(CompleteRows, AreAtLeastOneSampleLong) {
  const CompleteRows rows = complete_rows(counting(3), 0.01);
  EXPECT_EQ(rows.means.rate_dph, (std::vector<double>{0, 10, 20}));
}

TEST(CompleteRows, KeepAnIncompleteOneOnlyWhereThereIsNoOther) {
  const CompleteRows rows = complete_rows(counting(5, {0, 2}), 100);
  EXPECT_EQ(rows.means.rate_dph, std::vector<double>{30});
  EXPECT_EQ(rows.samples_per_row, 3U);
  EXPECT_EQ(complete_rows(counting(1), 10).means.rate_dph, std::vector<double>{0});
}

TEST(CompleteRows, BelongToTheSegmentInWhichTheirMiddleLies) {
  const CompleteRows rows = complete_rows(counting(20), 2);
  const std::vector<recording::Segment> segments{
      {"a", recording::SegmentKind::soak, 0, 3.5, {0, 7}},
      {"b", recording::SegmentKind::soak, 3.5, 4.5, {7, 9}},
      {"c", recording::SegmentKind::soak, 4.5, 10, {9, 20}}};
  const std::vector<recording::Segment> in_rows =
      recording::segments_on(segments, rows.means.time_s, {0, rows.means.rows()});
  EXPECT_EQ(in_rows[0].rows.end, 2U);  // the middle of row 1 is at 2.75 s
  EXPECT_EQ(in_rows[1].rows.size(), 0U);
  EXPECT_EQ(in_rows[2].rows.first, 2U);
  EXPECT_EQ(in_rows[2].rows.end, 5U);
}

}  // namespace
}  // namespace fogcomp::series
