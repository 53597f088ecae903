#include <gtest/gtest.h>

#include "diagnosis/diagnosis_data.hpp"

namespace fogcomp::diagnosis {
namespace {

RowLength of_runs(const std::vector<double>& hours, double block_s = 1) {
  std::vector<compare::RunInBlocks> runs;
  for (const double one : hours) {
    runs.emplace_back();
    runs.back().blocks.block_s = block_s;
    runs.back().blocks.blocks.resize(static_cast<std::size_t>(one * 3600 / block_s));
  }
  return row_length(runs);
}

TEST(RowLength, IsTenSecondsForAChamberRun) {
  EXPECT_EQ(of_runs({16.5}).row_s, 10);
  EXPECT_EQ(of_runs({16.5}).why, "");
  EXPECT_EQ(of_runs({1}).row_s, 10);
  EXPECT_EQ(of_runs({16.5, 16.5}, 10).row_s, 10);
}

TEST(RowLength, IsLongerWithTheReasonWhereThereWouldBeTooMany) {
  EXPECT_EQ(of_runs({34}).row_s, 20);
  EXPECT_EQ(of_runs({60}).row_s, 20);
  EXPECT_EQ(of_runs({60, 30}).row_s, 30);
  EXPECT_EQ(of_runs({1000}, 10).row_s, 60);
  EXPECT_NE(of_runs({1000}, 10).why.find("rows of 60 s"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::diagnosis
