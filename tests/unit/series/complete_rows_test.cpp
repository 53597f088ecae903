#include "series/blocks.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp {
namespace {

/// Row i at i * 0.5 s with temperature i and rate 10 i; gaps before the rows of `starts`.
Recording counting(std::size_t rows, std::vector<std::size_t> starts = {0}) {
  Recording recording;
  recording.period_s = 0.5;
  for (std::size_t i = 0; i < rows; ++i) {
    recording.time_s.push_back(static_cast<double>(i) * 0.5);
    recording.temperature_degc.push_back(static_cast<double>(i));
    recording.rate_dph.push_back(static_cast<double>(10 * i));
  }
  recording.stretch_starts = std::move(starts);
  return recording;
}

TEST(Blocks, AreMeansAroundTheirCentre) {
  Recording recording = counting(9);
  recording.input_rate_dph.assign(9, 0.1);
  const Blocks blocks = block_means(recording, 2);
  EXPECT_EQ(blocks.rows_per_block, 4U);
  EXPECT_EQ(blocks.means.period_s, 2);
  EXPECT_EQ(blocks.means.time_s, (std::vector<double>{0.75, 2.75}));
  EXPECT_EQ(blocks.means.temperature_degc, (std::vector<double>{1.5, 5.5}));
  EXPECT_EQ(blocks.means.rate_dph, (std::vector<double>{15, 55}));
  EXPECT_EQ(blocks.means.input_rate_dph, (std::vector<double>{0.1, 0.1}));
  EXPECT_TRUE(blocks.means[fog::Input::supply].empty());
}

TEST(Blocks, NeverCrossAGap) {
  const Blocks blocks = block_means(counting(20, {0, 7, 8, 12}), 2);
  EXPECT_EQ(blocks.first_rows, (std::vector<std::size_t>{0, 8, 12, 16}));
  EXPECT_EQ(blocks.means.stretch_starts, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Blocks, AreAtLeastOneRowLong) {
  const Blocks blocks = block_means(counting(3), 0.01);
  EXPECT_EQ(blocks.means.rate_dph, (std::vector<double>{0, 10, 20}));
}

TEST(Blocks, KeepAnIncompleteOneOnlyWhereThereIsNoOther) {
  const Blocks blocks = block_means(counting(5, {0, 2}), 100);
  EXPECT_EQ(blocks.means.rate_dph, std::vector<double>{30});
  EXPECT_EQ(blocks.rows_per_block, 3U);
  EXPECT_EQ(block_means(counting(1), 10).means.rate_dph, std::vector<double>{0});
}

TEST(Blocks, BelongToTheSegmentInWhichTheirMiddleLies) {
  const Blocks blocks = block_means(counting(20), 2);
  const std::vector<Segment> segments{{"a", SegmentKind::soak, 0, 3.5, {0, 7}},
                                      {"b", SegmentKind::soak, 3.5, 4.5, {7, 9}},
                                      {"c", SegmentKind::soak, 4.5, 10, {9, 20}}};
  const std::vector<Segment> in_blocks =
      segments_on(segments, blocks.means.time_s, {0, blocks.means.rows()});
  EXPECT_EQ(in_blocks[0].rows.end, 2U);  // the middle of block 1 is at 2.75 s
  EXPECT_EQ(in_blocks[1].rows.size(), 0U);
  EXPECT_EQ(in_blocks[2].rows.first, 2U);
  EXPECT_EQ(in_blocks[2].rows.end, 5U);
}

}  // namespace
}  // namespace fogcomp
