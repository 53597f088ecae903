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

Eigen::VectorXd in_ramp(const std::string& effect, Phase phase) {
  model::Model model;
  model.average_s = 10;
  model.derivative_tau_s = 10;
  SignalSeries series(model, phase);
  series.add(make_blocks(begun_on_a_ramp()));
  return series.regressors(model::parse_effects(effect)[0]).col(0);
}

// The board's lag begins at 0. Had the ramp been there for ever, it would begin at tau times 0.1
// degC/s, 100 degC, and differ for 1,000 s.
TEST(SignalSeries, BeginsALagAtRestWithAndWithoutTheBoardsDelay) {
  const Eigen::VectorXd board = in_ramp("thermal_lag:tau=1000", Phase::board);
  const Eigen::VectorXd zero = in_ramp("thermal_lag:tau=1000", Phase::zero);
  ASSERT_EQ(board.size(), zero.size());
  const double max = board.cwiseAbs().maxCoeff();
  EXPECT_GT(max, 0);
  EXPECT_LT((board - zero).cwiseAbs().maxCoeff(), 0.06 * max);
}

// A jump is where it is, whether the block before or the present one is read.
TEST(SignalSeries, HasABiasStepInTheSameRowWithAndWithoutTheBoardsDelay) {
  const Eigen::VectorXd board = in_ramp("bias_step:at=1000", Phase::board);
  const Eigen::VectorXd zero = in_ramp("bias_step:at=1000", Phase::zero);
  EXPECT_EQ(board, zero);
  EXPECT_EQ(board.minCoeff(), 0);
  EXPECT_EQ(board.maxCoeff(), 1);
}

// On for an hour, off for ten minutes, on again; the recorder's clock goes on.
recording::Recording switched_off_once() {
  recording::Recording recording;
  recording.file = "restart.csv";
  recording.period_s = 10;
  for (int time_s = 0; time_s < 7200; time_s += 10) {
    if (time_s >= 3600 && time_s < 4200) continue;
    recording.time_s.push_back(time_s);
    recording.uptime_s.push_back(time_s < 4200 ? time_s : time_s - 4200);
    recording.temperature_degc.push_back(20 + 0.01 * time_s);
    recording.rate_dph.push_back(0.001 * (time_s / 10 % 7));
  }
  recording.stretch_starts = {0, 360};
  return recording;
}

Eigen::VectorXd regressor_of(const std::string& effect, const recording::Recording& recording) {
  model::Model model;
  model.average_s = 10;
  SignalSeries series(model);
  series.add(make_blocks(recording));
  return series.regressors(model::parse_effects(effect)[0]).col(0);
}

// The row at 4210 s: at a restart the first block only starts the model.
constexpr Eigen::Index kRestart = 360;

// The board's first block after a restart is no row of its own: it begins there.
TEST(SignalSeries, KnowsThePowerOnsOfARecording) {
  model::Model model;
  model.average_s = 60;
  for (const Phase phase : {Phase::board, Phase::zero}) {
    SignalSeries series(model, phase);
    series.add(make_blocks(switched_off_once()));
    series.add(make_blocks(begun_on_a_ramp()));
    const std::vector<recording::RowRange> power_ons = series.rows().bias_ranges();
    ASSERT_EQ(power_ons.size(), 3U);
    EXPECT_EQ(power_ons[1].first, 60U);
    EXPECT_GE(series.rows().time_s[power_ons[1].first], 4200);
    EXPECT_EQ(power_ons[2].first, series.rows().run_starts[1]);
    series.share_bias(BiasOf::recording);
    EXPECT_EQ(series.rows().bias_ranges().size(), 2U);
  }
}

TEST(SignalSeries, BeginsAWarmUpAnewAtARestartAsFarAsItHasCooled) {
  const Eigen::VectorXd warm_up = regressor_of("warm_up:tau=900", switched_off_once());
  ASSERT_EQ(warm_up.size(), 659);
  const double warm = 1 - std::exp(-3590.0 / 900);
  const double cooled = 1 - warm * std::exp(-610.0 / 900);
  EXPECT_NEAR(warm_up[kRestart], cooled * std::exp(-10.0 / 900), 1e-6);
  EXPECT_NEAR(warm_up[kRestart + 90] / warm_up[kRestart], std::exp(-1.0), 1e-6);
}

TEST(SignalSeries, AgesOnThroughARestart) {
  const Eigen::VectorXd age = regressor_of("aging:t0=3600", switched_off_once());
  EXPECT_NEAR(4 * age[kRestart], std::log1p(4210.0 / 3600), 1e-6);
  const Eigen::VectorXd hastened = regressor_of("aging:t0=3600,q10=1.3", switched_off_once());
  EXPECT_GT(hastened[kRestart], age[kRestart]);
}

TEST(SignalSeries, BeginsLagsAnewAtARestartHoweverShort) {
  recording::Recording recording = switched_off_once();
  const double gone_on = regressor_of("thermal_lag:tau=900", recording)[kRestart];
  for (std::size_t row = 360; row < recording.rows(); ++row) recording.time_s[row] -= 600;
  const Eigen::VectorXd lag = regressor_of("thermal_lag:tau=900", recording);
  EXPECT_EQ(lag.size(), 659);
  EXPECT_NEAR(lag[kRestart], gone_on, 1e-6);
  recording.uptime_s.clear();
  EXPECT_EQ(regressor_of("thermal_lag:tau=900", recording).size(), 660);
}

TEST(SignalSeries, KnowsThePowerOnOfARecordingThatBeganLater) {
  recording::Recording recording = switched_off_once();
  recording.time_s.resize(300);
  recording.temperature_degc.resize(300);
  recording.rate_dph.resize(300);
  recording.stretch_starts = {0};
  recording.uptime_s = recording.time_s;
  for (double& uptime_s : recording.uptime_s) uptime_s += 900;
  const Eigen::VectorXd late = regressor_of("warm_up:tau=900", recording);
  recording.uptime_s.clear();
  const Eigen::VectorXd from_start = regressor_of("warm_up:tau=900", recording);
  EXPECT_NEAR(late[0] / from_start[0], std::exp(-1.0), 1e-9);
}

// A rate table that turns at once, half way through a block: the board takes each sample's rate.
TEST(SignalSeries, TakesANonlinearityOfEverySampleAndNotOfTheMean) {
  recording::Recording recording;
  recording.file = "table.csv";
  recording.period_s = 0.1;
  recording.stretch_starts = {0};
  for (int row = 0; row < 400; ++row) {
    recording.time_s.push_back(0.1 * row);
    recording.temperature_degc.push_back(20);
    recording.input_rate_dph.push_back(row < 205 ? 0 : 720000);
    recording.rate_dph.push_back(recording.input_rate_dph.back() + 0.001 * (row % 7));
  }
  const BlockSeries blocks = make_blocks(recording);
  const auto effect =
      model::parse_effects("scale_factor_nonlinearity:order=3,full_scale=200").front();
  for (const Phase phase : {Phase::board, Phase::zero}) {
    model::Model model;
    model.average_s = 1;
    SignalSeries series(model, phase);
    series.add(blocks);
    const Eigen::MatrixXd columns = series.regressors(effect);
    const Eigen::Index rows = columns.rows();
    EXPECT_EQ(columns.topRows(rows - 21).cwiseAbs().maxCoeff(), 0);
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      const double whole = columns(rows - 1, i);
      EXPECT_GT(whole, 0);
      EXPECT_NEAR(columns(rows - 20, i), whole / 2, 1e-12 * whole);
    }
  }
}

// A table that turns ever faster, recorded at 10 Hz with the second half of each third second lost.
TEST(SignalSeries, TakesTheRiseOfAWholeBlockFromThePartThatIsThere) {
  recording::Recording recording;
  recording.file = "table.csv";
  recording.period_s = 0.1;
  for (int row = 0; row < 600; ++row) {
    if (row % 30 >= 25) continue;
    if (row % 30 == 0) recording.stretch_starts.push_back(recording.rows());
    recording.time_s.push_back(0.1 * row);
    recording.temperature_degc.push_back(20);
    recording.input_rate_dph.push_back(360.0 * row);
    recording.rate_dph.push_back(recording.input_rate_dph.back() + 0.001 * (row % 7));
  }
  model::Model model;
  model.average_s = 1;
  SignalSeries series(model);
  series.add(make_blocks(recording));
  const Eigen::MatrixXd rise = series.regressors(model::parse_effects("late_reference").front());
  EXPECT_GT(rise.minCoeff(), 0);
  EXPECT_NEAR(rise.maxCoeff(), rise.minCoeff(), 1e-9 * rise.maxCoeff());
}

// The lag counts from the present block: without one a ramp shows W T, with the board's delay, too.
TEST(SignalSeries, AScaleFactorFollowsTheTemperatureOfThePresentBlock) {
  recording::Recording recording = begun_on_a_ramp();
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    recording.input_rate_dph.push_back(360000);
  }
  const auto effect = model::parse_effects("scale_factor_temperature:reference=20").front();
  for (const Phase phase : {Phase::board, Phase::zero}) {
    model::Model model;
    model.average_s = 1;
    model.derivative_tau_s = 10;
    SignalSeries series(model, phase);
    series.add(make_blocks(recording));
    const Eigen::MatrixXd column = series.regressors(effect);
    const double per_degc = column(1900, 0) / 50;
    EXPECT_NEAR(column(400, 0) / per_degc, 40, 0.002) << static_cast<int>(phase);
  }
}

}  // namespace
}  // namespace fogcomp::series
