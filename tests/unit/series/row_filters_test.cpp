#include "series/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/thermal/first_order_lag.hpp"

namespace fogcomp::series {
namespace {

using Eigen::VectorXd;

Rows rows_at(std::vector<double> time_s, std::vector<std::size_t> run_starts = {0}) {
  Rows rows;
  rows.row_s = 10;
  rows.drift_dph.setZero(static_cast<Eigen::Index>(time_s.size()));
  rows.time_s = std::move(time_s);
  rows.run_starts = std::move(run_starts);
  return rows;
}

// The step response after a time is 1 - exp(-time / tau), however many rows are in between.
TEST(RowFilters, ALagFollowsAStepByTheTimeThatPassed) {
  const Rows rows = rows_at({0, 10, 20, 50, 250});
  VectorXd values(5);
  values << 0, 1, 1, 1, 1;
  const VectorXd lag = first_order_lag(rows, values, 40);
  EXPECT_EQ(lag[0], 0);
  for (const Eigen::Index i : {1, 2, 3, 4}) {
    EXPECT_NEAR(lag[i], 1 - std::exp(-rows.time_s[static_cast<std::size_t>(i)] / 40), 1e-15) << i;
  }
}

TEST(RowFilters, ALagIsTheBoardsWhereRowsAreEquallyFarApart) {
  const Rows rows = rows_at({0, 10, 20, 30, 40});
  VectorXd values(5);
  values << 3, 1, 4, 1, 5;
  const VectorXd lag = first_order_lag(rows, values, 25);
  fog::FirstOrderLag<model::RealNumbers> board(model::RealNumbers::decay(10.0 / 25));
  board.reset(values[0]);
  for (Eigen::Index i = 1; i < 5; ++i) EXPECT_EQ(lag[i], board.step(values[i])) << i;
}

TEST(RowFilters, EveryRecordingBeginsSettled) {
  const Rows rows = rows_at({0, 10, 0, 10}, {0, 2});
  const VectorXd values = Eigen::Vector4d(1, 1, 7, 7);
  EXPECT_EQ(first_order_lag(rows, values, 100), values);
  EXPECT_EQ(smoothed(rows, values, 100), values);
}

// Forward and backward filtering has no delay: a symmetric signal stays symmetric, an impulse keeps
// its position, and away from the ends its sum is kept.
TEST(RowFilters, SmoothingHasNoDelayAndKeepsTheSum) {
  std::vector<double> time_s;
  for (int i = 0; i < 401; ++i) time_s.push_back(10.0 * i);
  const Rows rows = rows_at(time_s);
  VectorXd impulse = VectorXd::Zero(401);
  impulse[200] = 1;
  const VectorXd smooth = smoothed(rows, impulse, 50);
  EXPECT_NEAR(smooth.sum(), 1, 1e-12);
  EXPECT_LT((smooth - smooth.reverse()).cwiseAbs().maxCoeff(), 1e-15);
  const double decay = std::exp(-10.0 / 50);  // of both sides of the impulse
  EXPECT_NEAR(smooth[200], (1 - decay) / (1 + decay), 1e-15);
  EXPECT_NEAR(smooth[207] / smooth[206], decay, 1e-12);
}

}  // namespace
}  // namespace fogcomp::series
