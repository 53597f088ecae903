#include "compare/model_on_runs.hpp"

#include <gtest/gtest.h>

namespace fogcomp::compare {
namespace {

ModelOnRun run_with(double rms_dph, double floor_dph, std::size_t rows, double outside) {
  ModelOnRun run;
  run.comparison.whole.rms_dph = rms_dph;
  run.comparison.noise_floor_dph = floor_dph;
  run.comparison.outlier.resize(rows);
  run.comparison.outside.temperature = outside;
  return run;
}

ModelOnRuns model_with(const std::string& file, std::vector<ModelOnRun> runs) {
  return {file, {}, std::move(runs)};
}

TEST(ModelOnRuns, Worst_IsTheRunWithTheLargestDrift) {
  // The second has the larger error, of noise.
  const ModelOnRuns model = model_with("m", {run_with(5, 3, 10, 0), run_with(6, 5, 10, 0)});
  EXPECT_EQ(&model.worst(), &model.runs[0]);
}

TEST(ModelOnRuns, BestFirst_KeepsTheOrderOfTheOthers) {
  const std::vector<ModelOnRuns> models{model_with("a", {run_with(3, 1, 10, 0)}),
                                        model_with("b", {run_with(4, 1, 10, 0)}),
                                        model_with("c", {run_with(2, 1, 10, 0)})};
  std::string order;
  for (const ModelOnRuns* const model : best_first(models)) order += model->file;
  EXPECT_EQ(order, "cab");
}

TEST(ModelOnRuns, ExtrapolatedFraction_CountsRowsNotRuns) {
  EXPECT_DOUBLE_EQ(
      model_with("m", {run_with(1, 1, 30, 0.5), run_with(1, 1, 10, 0.1)}).extrapolated_fraction(),
      0.4);
  EXPECT_EQ(ModelOnRuns().extrapolated_fraction(), 0);
}

}  // namespace
}  // namespace fogcomp::compare
