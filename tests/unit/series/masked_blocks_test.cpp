// Masked blocks have no row, but their temperatures are used.

#include <gtest/gtest.h>

#include <cmath>

#include "model/effect_list.hpp"
#include "series/signal_series.hpp"
#include "support/input_error.hpp"

namespace fogcomp::series {
namespace {

recording::Recording ramp(const std::vector<recording::Mask>& masks) {
  recording::Recording recording;
  recording.file = "ramp.csv";
  recording.period_s = 10;
  recording.stretch_starts = {0};
  recording.masks = masks;
  for (int row = 0; row < 400; ++row) {
    recording.time_s.push_back(10 * row);
    recording.temperature_degc.push_back(20 + 10 * std::sin(row / 40.0));
    recording.rate_dph.push_back(0.001 * (row % 7));
  }
  return recording;
}

class MaskedBlocks : public testing::TestWithParam<Phase> {};

TEST_P(MaskedBlocks, LeaveTheOtherRowsAsTheyAre) {
  model::Model model;
  model.average_s = 10;
  model.derivative_tau_s = 30;
  const model::EffectTerm lag = model::parse_effects("thermal_lag:tau=300")[0];
  SignalSeries whole(model, GetParam());
  whole.add(make_blocks(ramp({})));
  SignalSeries masked(model, GetParam());
  masked.add(make_blocks(ramp({{"", 1000, 1990}})));
  const Eigen::MatrixXd all = whole.regressors(lag);
  const Eigen::MatrixXd left = masked.regressors(lag);
  ASSERT_EQ(left.rows(), all.rows() - 100);
  const std::vector<double>& times = masked.rows().time_s;
  for (Eigen::Index row = 0; row < left.rows(); ++row) {
    const double time_s = times[static_cast<std::size_t>(row)];
    EXPECT_TRUE(time_s < 1000 || time_s > 1990);
    EXPECT_EQ(left(row, 0), all(time_s < 1000 ? row : row + 100, 0)) << time_s;
  }
  EXPECT_EQ(masked.rows().stretches().size(), whole.rows().stretches().size() + 1);
}

INSTANTIATE_TEST_SUITE_P(InBothPhases, MaskedBlocks, testing::Values(Phase::board, Phase::zero));

TEST(MaskedBlocksOfAWholeRun, AreRefused) {
  EXPECT_THROW(make_blocks(ramp({{"", 0, 1e6}})), InputError);
}

}  // namespace
}  // namespace fogcomp::series
