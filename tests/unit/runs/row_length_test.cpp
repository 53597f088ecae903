#include "runs/run.hpp"

#include <gtest/gtest.h>

namespace fogcomp::runs {
namespace {

RowLength of_runs(const std::vector<double>& hours, double model_row_s = 10, double block_s = 1) {
  std::vector<runs::Run> runs;
  for (const double one : hours) {
    runs.emplace_back();
    runs.back().blocks.block_s = block_s;
    runs.back().blocks.blocks.resize(static_cast<std::size_t>(one * 3600 / block_s));
  }
  return row_length(runs, model_row_s);
}

TEST(RowLength, IsTenSecondsForAChamberRun) {
  EXPECT_EQ(of_runs({16.5}).row_s, 10);
  EXPECT_EQ(of_runs({16.5}).why, "");
  EXPECT_EQ(of_runs({1}).row_s, 10);
  EXPECT_EQ(of_runs({16.5, 16.5}, 10, 10).row_s, 10);
}

TEST(RowLength, DoesNotDependOnTheModels) {
  for (const double model_row_s : {1.0, 2.0, 20.0, 60.0}) {
    EXPECT_EQ(of_runs({3}, model_row_s).row_s, 10) << model_row_s;
    EXPECT_EQ(of_runs({60}, model_row_s).row_s, 20) << model_row_s;
  }
}

TEST(RowLength, IsTheModelsWhereThatMakesTheSameRows) {
  EXPECT_EQ(of_runs({3}, 60, 60).row_s, 60);  // the recording's own are longer than both
  EXPECT_EQ(of_runs({3}, 10.1, 1.01).row_s, 10.1);
}

TEST(RowLength, IsTheModelsWhereLongerRowsWouldBeTooFew) {
  EXPECT_EQ(of_runs({0.2}, 1).row_s, 1);
  EXPECT_EQ(of_runs({0.2}, 30).row_s, 10);
}

TEST(RowLength, IsLongerWithTheReasonWhereThereWouldBeTooMany) {
  EXPECT_EQ(of_runs({34}).row_s, 20);
  EXPECT_EQ(of_runs({60}).row_s, 20);
  EXPECT_EQ(of_runs({60, 30}).row_s, 30);
  EXPECT_EQ(of_runs({180}, 10, 10).row_s, 60);
  EXPECT_EQ(of_runs({1000}, 10, 10).row_s, 300);
  EXPECT_NE(of_runs({1000}, 10, 10).why.find("rows of 300 s"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::runs
