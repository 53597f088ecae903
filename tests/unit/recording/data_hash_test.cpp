#include "recording/data_hash.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/bytes/crc.hpp"
#include "recording/columns.hpp"

namespace {

TEST(DataHash, ChangesWithEveryColumnThatAFitCanDependOn) {
  fogcomp::Recording plain;
  plain.time_s = {0, 1, 2};
  plain.temperature_degc = {20, 21, 22};
  plain.rate_dph = {0.1, 0.2, 0.3};
  const auto hash = [](const fogcomp::Recording& recording) {
    return fogcomp::data_hash(recording, fog::kCrc32Initial);
  };
  std::set<std::uint32_t> hashes{hash(plain)};
  for (const auto& [column, name, decimals, least, most] : fogcomp::kColumns) {
    fogcomp::Recording recording = plain;
    recording[column] = {1, 2, 4};
    EXPECT_TRUE(hashes.insert(hash(recording)).second) << name;
  }
  plain.temperature_degc[1] = 21.001;
  EXPECT_TRUE(hashes.insert(hash(plain)).second);
}

TEST(RowsHash, IsOfTheNumbersAndNotOfTheFile) {
  fogcomp::Recording run;
  run.file = "run.csv";
  run.time_s = {0, 1, 2};
  run.temperature_degc = {20, 21, 22};
  run.rate_dph = {0.1, 0, 0.3};
  fogcomp::Recording copy = run;
  copy.file = "copy.csv";
  copy[fog::Input::magnetic] = {1, 2, 3};  // a column more
  copy.rate_dph[1] = -0.0;                 // another way to write it
  EXPECT_EQ(fogcomp::rows_hash(run), fogcomp::rows_hash(copy));
  fogcomp::KnownRows known;
  known.add(fogcomp::rows_hash(run), run.file);
  EXPECT_EQ(known.file_with(fogcomp::rows_hash(copy)), "run.csv");
  copy.rate_dph[2] = 0.4;
  EXPECT_EQ(known.file_with(fogcomp::rows_hash(copy)), "");
  std::swap(copy.rate_dph, copy.time_s);
  EXPECT_NE(fogcomp::rows_hash(run), fogcomp::rows_hash(copy));
}

}  // namespace
