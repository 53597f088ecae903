#include "recording/data_hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "core/bytes/crc.hpp"
#include "recording/columns.hpp"

namespace fogcomp::recording {
namespace {

TEST(DataHash, ChangesWithEveryColumnThatAFitCanDependOn) {
  Recording plain;
  plain.time_s = {0, 1, 2};
  plain.temperature_degc = {20, 21, 22};
  plain.rate_dph = {0.1, 0.2, 0.3};
  const auto hash = [](const Recording& recording) {
    return data_hash(recording, fog::kCrc32Initial);
  };
  std::set<std::uint32_t> hashes{hash(plain)};
  for (const auto& [column, name, decimals, min, max] : kColumns) {
    Recording recording = plain;
    recording[column] = {1, 2, 4};
    EXPECT_TRUE(hashes.insert(hash(recording)).second) << name;
  }
  plain.temperature_degc[1] = 21.001;
  EXPECT_TRUE(hashes.insert(hash(plain)).second);
}

TEST(RowsHash, IsOfTheNumbersAndNotOfTheFile) {
  Recording run;
  run.file = "run.csv";
  run.time_s = {0, 1, 2};
  run.temperature_degc = {20, 21, 22};
  run.rate_dph = {0.1, 0, 0.3};
  Recording copy = run;
  copy.file = "copy.csv";
  copy[fog::Input::magnetic] = {1, 2, 3};  // a column more
  copy.rate_dph[1] = -0.0;                 // another way to write it
  EXPECT_EQ(rows_hash(run), rows_hash(copy));
  KnownRows known;
  known.add(rows_hash(run), run.file);
  EXPECT_EQ(known.file_with(rows_hash(copy)), "run.csv");
  copy.rate_dph[2] = 0.4;
  EXPECT_EQ(known.file_with(rows_hash(copy)), "");
  std::swap(copy.rate_dph, copy.time_s);
  EXPECT_NE(rows_hash(run), rows_hash(copy));
}

TEST(SampleMarks, PartOfARecording_SharesSome) {
  Recording run;
  for (int row = 0; row < 5000; ++row) {
    run.time_s.push_back(row);
    run.rate_dph.push_back(row * row % 101);
  }
  const auto shared = [&](std::size_t first, std::size_t end, double later_s) {
    Recording part;
    for (std::size_t row = first; row < end; ++row) {
      part.time_s.push_back(run.time_s[row] + later_s);
      part.rate_dph.push_back(run.rate_dph[row]);
    }
    const auto all = sample_marks(run);
    const auto own = sample_marks(part);
    return std::count_if(own.begin(), own.end(), [&](std::uint64_t mark) {
      return std::count(all.begin(), all.end(), mark) > 0;
    });
  };
  EXPECT_EQ(shared(0, 5000, 0), 64);
  EXPECT_GT(shared(0, 500, 0), 0);
  EXPECT_GT(shared(4400, 5000, 0), 0);
  EXPECT_EQ(shared(0, 5000, 0.5), 0);
}

// Two gyros that send one of three counts, at the same times.
TEST(SampleMarks, CoarseRatesOfAnotherGyro_NoneShared) {
  std::mt19937_64 random(1);
  std::vector<std::vector<std::uint64_t>> marks;
  for (int gyro = 0; gyro < 2; ++gyro) {
    Recording run;
    for (int row = 0; row < 5000; ++row) {
      run.time_s.push_back(row);
      run.rate_dph.push_back(static_cast<double>(random() % 3));
    }
    marks.push_back(sample_marks(run));
  }
  EXPECT_EQ(std::find_first_of(marks[0].begin(), marks[0].end(), marks[1].begin(), marks[1].end()),
            marks[0].end());
}

}  // namespace
}  // namespace fogcomp::recording
