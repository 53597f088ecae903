#include "recording/long_recording.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "heard_in.hpp"
#include "recording/decision_rules.hpp"
#include "support/input_error.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kPeriodS = 0.005;

// Rows from `first` on: a slow temperature, and a rate that identifies the row.
Recording rows_from(std::size_t first, std::size_t count) {
  Recording part;
  for (std::size_t row = first; row < first + count; ++row) {
    const auto number = static_cast<double>(row);
    part.time_s.push_back(kPeriodS * number);
    part.temperature_degc.push_back(20 + 1e-6 * number);
    part.rate_dph.push_back(1e-3 * number);
  }
  return part;
}

Recording means_of_parts(std::size_t parts, std::size_t part_rows, std::string& said) {
  const ReadOptions options = heard_in(said);
  LongRecording recording(options, kMaxRows + 1);
  LineNumbers lines;
  for (std::size_t i = 0; i < parts; ++i) {
    Recording part = rows_from(i * part_rows, part_rows);
    recording.take(part, lines, "long.csv:1");
    EXPECT_EQ(part.rows(), 0U);
  }
  return recording.finish("long.csv");
}

TEST(LongRecording, KeepsMeansOfNeighboursOfAllRowsInBoundedMemory) {
  std::string said;
  const std::size_t parts = 5;  // of which a fifth has no room as rows
  const Recording means = means_of_parts(parts, rules::kPartRows, said);
  const std::size_t rows = parts * rules::kPartRows;
  ASSERT_EQ(means.rows_per_row, 2U);
  ASSERT_EQ(means.rows(), rows / 2);
  EXPECT_LE(means.rows(), rules::kMaxMeanRows);
  for (std::size_t i = 0; i < means.rows(); i += 999) {
    const double middle = 2 * static_cast<double>(i) + 0.5;
    EXPECT_NEAR(means.time_s[i], kPeriodS * middle, 1e-6);
    EXPECT_NEAR(means.rate_dph[i], 1e-3 * middle, 1e-6);
    EXPECT_NEAR(means.temperature_degc[i], 20 + 1e-6 * middle, 1e-6);
  }
  EXPECT_NE(said.find("long.csv: 5242880 samples: read in means of 2 (0.01 s), 2621440 of them"),
            std::string::npos)
      << said;
}

TEST(LongRecording, OfAPipeIsThatOfTheFile) {
  std::string said;
  const ReadOptions options = heard_in(said);
  LongRecording from_pipe(options, 0);
  LongRecording from_file(options, kMaxRows + 1);
  const std::size_t rows = 2 * rules::kPartRows + 1000;
  Recording whole = rows_from(0, rows);
  whole.labels = {{0, "soak"}, {rules::kPartRows + 10, "ramp"}};
  LineNumbers lines;
  for (std::size_t row = 0; row < rows; ++row) lines.add(row, row + 2 + row / rules::kPartRows);
  from_pipe.take(whole, lines, "-");
  ASSERT_EQ(whole.rows(), 1000U);  // the beginning of the next part
  EXPECT_EQ(whole.time_s[0], rows_from(2 * rules::kPartRows, 1).time_s[0]);
  EXPECT_EQ(lines.line_of(0), 2 * rules::kPartRows + 4);
  ASSERT_EQ(whole.labels.size(), 1U);
  EXPECT_EQ(whole.labels[0].text, "ramp");
  from_pipe.take(whole, lines, "-");
  for (std::size_t first = 0; first < rows; first += rules::kPartRows) {
    Recording part = rows_from(first, std::min(rules::kPartRows, rows - first));
    part.labels = {{0, first == 0 ? "soak" : "ramp"}};
    if (first == rules::kPartRows) part.labels = {{0, "soak"}, {10, "ramp"}};
    LineNumbers none;
    from_file.take(part, none, "long.csv");
  }
  const Recording of_pipe = from_pipe.finish("-");
  const Recording of_file = from_file.finish("long.csv");
  EXPECT_EQ(of_pipe.rows_per_row, of_file.rows_per_row);
  EXPECT_EQ(of_pipe.time_s, of_file.time_s);
  EXPECT_EQ(of_pipe.rate_dph, of_file.rate_dph);
  ASSERT_EQ(of_pipe.labels.size(), of_file.labels.size());
  EXPECT_EQ(of_pipe.labels[1].first_row, of_file.labels[1].first_row);
}

// What is left of one part gets further rows, in which each temperature may be a reading.
TEST(LongRecording, PipeWithFewReadings_NextPartTaken) {
  const ReadOptions options;
  LongRecording from_pipe(options, 0);
  constexpr std::size_t kRest = 1000;
  Recording part = rows_from(0, rules::kPartRows + kRest);
  part.temperature_is_read.resize(part.rows());
  part.temperature_is_read[0] = true;
  LineNumbers lines;
  from_pipe.take(part, lines, "-");
  ASSERT_EQ(part.rows(), kRest);
  const Recording more = rows_from(rules::kPartRows + kRest, kRest);
  for (const Column column : {Column::time_s, Column::temperature_degc, Column::rate_dph}) {
    part[column].insert(part[column].end(), more[column].begin(), more[column].end());
  }
  from_pipe.take(part, lines, "-");
  const Recording means = from_pipe.finish("-");
  ASSERT_EQ(means.temperature_is_read.size(), means.rows());
  EXPECT_TRUE(means.temperature_is_read.front());
  EXPECT_FALSE(means.temperature_is_read[1]);
  const auto next = means.temperature_is_read.begin() + std::ptrdiff_t{rules::kPartRows};
  EXPECT_EQ(std::count(next, means.temperature_is_read.end(), true), 2 * kRest);
}

TEST(LongRecording, TakesNoMeanAcrossAGapOrTheEndOfASegment) {
  const ReadOptions options;
  LongRecording recording(options, kMaxRows + 1);
  LineNumbers lines;
  Recording part = rows_from(0, rules::kMaxMeanRows + 2);
  for (std::size_t row = 1001; row < part.rows(); ++row) part.time_s[row] += 500;
  part.labels = {{0, "warm"}, {3001, "cold"}};
  recording.take(part, lines, "long.csv:1");
  recording.take(part, lines, "long.csv:1");  // what is left of the last part
  const Recording means = recording.finish("long.csv");
  EXPECT_EQ(means.rows_per_row, 2U);
  EXPECT_NEAR(means.time_s[500], kPeriodS * 1000, 1e-9);  // alone before the gap
  EXPECT_NEAR(means.time_s[501], kPeriodS * 1001.5 + 500, 1e-9);
  ASSERT_EQ(means.labels.size(), 2U);
  EXPECT_EQ(means.labels[1].first_row, 1501U);
  EXPECT_NEAR(means.time_s[1501], kPeriodS * 3001.5 + 500, 1e-9);
}

// A mean would reduce a spike, and no board accepts it.
TEST(LongRecording, LeavesOutWhatTheBoardWouldRefuseBeforeItTakesMeans) {
  std::string said;
  const ReadOptions options = heard_in(said);
  LongRecording recording(options, kMaxRows + 1);
  LineNumbers lines;
  Recording part = rows_from(0, rules::kPartRows);
  part.temperature_degc[5000] = 85;
  part.rate_dph[7000] = 1e8;
  recording.take(part, lines, "long.csv:1");
  const Recording means = recording.finish("long.csv");
  EXPECT_EQ(means.refused_rows, 11U);  // the rate for 50 ms, as the board does
  EXPECT_LT(*std::max_element(means.temperature_degc.begin(), means.temperature_degc.end()), 25);
  EXPECT_NE(said.find("11 samples left out by the board's rules, the first: "), std::string::npos)
      << said;
}

TEST(LongRecording, BeginsWithMeansOnlyWhereTheFileIsSurelyTooLong) {
  const ReadOptions options;
  EXPECT_FALSE(LongRecording(options, kMaxRows).begun());
  EXPECT_TRUE(LongRecording(options, kMaxRows + 1).begun());
  // Found to be too long on the way: the rows so far become means.
  LongRecording recording(options, 0);
  Recording part = rows_from(0, rules::kMaxMeanRows + 2);
  LineNumbers lines;
  recording.take(part, lines, "long.csv:1");
  recording.take(part, lines, "long.csv:1");  // what is left of the last part
  EXPECT_EQ(recording.finish("long.csv").rows_per_row, 2U);
}

TEST(LongRecording, IsRefusedWhereEveryRowIsNeeded) {
  ReadOptions options;
  options.every_row = true;
  LongRecording recording(options, 10 * kMaxRows);
  EXPECT_EQ(recording.part_rows(), kMaxRows);
  Recording part = rows_from(0, 10);
  LineNumbers lines;
  EXPECT_THROW(recording.take(part, lines, "long.csv:11"), InputError);
}

}  // namespace
}  // namespace fogcomp::recording
