#include "series/signal_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/effect_list.hpp"

namespace fogcomp::series {
namespace {

// Begins on a ramp of 6 degC/min.
recording::Recording begun_on_a_ramp() {
  recording::Recording recording;
  recording.file = "ramp.csv";
  recording.period_s = 1;
  recording.stretch_starts = {0};
  for (int row = 0; row < 2000; ++row) {
    recording.time_s.push_back(row);
    recording.temperature_degc.push_back(row < 500 ? 20 + 0.1 * row : 70);
    recording.rate_dph.push_back(0.001 * (row % 7));
  }
  return recording;
}

Eigen::VectorXd lag_of(Phase phase) {
  model::Model model;
  model.average_s = 10;
  model.derivative_tau_s = 10;
  SignalSeries series(model, phase);
  series.add(make_blocks(begun_on_a_ramp()));
  return series.regressors(model::parse_effects("thermal_lag:tau=1000")[0]).col(0);
}

// The board's lag begins at 0. Had the ramp been there for ever, it would begin at tau times 0.1
// degC/s, 100 degC, and differ for 1,000 s.
TEST(SignalSeries, BeginsALagAtRestWithAndWithoutTheBoardsDelay) {
  const Eigen::VectorXd board = lag_of(Phase::board);
  const Eigen::VectorXd zero = lag_of(Phase::zero);
  ASSERT_EQ(board.size(), zero.size());
  const double max = board.cwiseAbs().maxCoeff();
  EXPECT_GT(max, 0);
  EXPECT_LT((board - zero).cwiseAbs().maxCoeff(), 0.06 * max);
}

}  // namespace
}  // namespace fogcomp::series
