#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "board/host_compensator.hpp"
#include "board/sensor_stream.hpp"
#include "model/drift_model.hpp"
#include "series/block_walk.hpp"
#include "support/typical_effects.hpp"

// Fit and compare treat a recording like the board: the same blocks, the same time, the same
// inputs, also where samples are missing.
namespace {

constexpr int kSamplesPerBlock = 10;
constexpr double kPeriodS = 0.1;

double on_grid(double value) {
  return std::round(value * 65536) / 65536;
}

// Three hours of ramps with all inputs in motion; gaps within a block, over blocks, and longer than
// the board holds its drift.
fogcomp::recording::Recording recording_with_gaps() {
  fogcomp::recording::Recording recording;
  recording.file = "gaps.csv";
  recording.period_s = kPeriodS;
  const auto missing = [](int i) {
    return (i > 5003 && i < 5008) || (i > 20004 && i < 20057) || (i > 60000 && i < 61234);
  };
  for (int i = 0; i < 108000; ++i) {
    if (missing(i)) continue;
    const double t = i * kPeriodS;
    recording.time_s.push_back(t);
    recording.temperature_degc.push_back(on_grid(10 + 40 * std::sin(t / 1500)));
    recording.rate_dph.push_back(on_grid(0.7 + 0.1 * ((i * 37) % 11)));
    recording[fog::Input::temperature2].push_back(on_grid(10 + 40 * std::sin(t / 1500 + 0.1)));
    recording[fog::Input::magnetic].push_back(on_grid(50 * std::cos(t / 700)));
    recording[fog::Input::light_power].push_back(on_grid(90 + 20 * std::sin(t / 900)));
    recording[fog::Input::vibration].push_back(on_grid(2 + 2 * std::sin(t / 300)));
  }
  return recording;
}

// Mean drift of the board in each block, by the block's number: effects that follow the input rate
// differ from sample to sample.
std::map<std::int64_t, double> board_drift(const fogcomp::model::Model& model,
                                           const fogcomp::recording::Recording& recording) {
  fogcomp::board::BoardSettings settings = fog::test::lenient_board();
  settings.sample_rate_hz = 1 / kPeriodS;
  settings.extension = true;
  const fogcomp::board::BoardTable table = fogcomp::board::make_board_table(model, settings);
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
  fogcomp::board::HostCompensator board(parameters, fog::IntegrityToken::not_needed());
  std::array<std::uint8_t, fog::kMaxOutputBytes> frames;
  std::map<std::int64_t, std::pair<double, int>> sums;
  std::size_t row = 0;
  fogcomp::board::make_sensor_stream(recording, model.scale_factor, fogcomp::model::needs_of(model),
                                     [&](auto bytes, fog::SampleTime) {
                                       for (const std::uint8_t byte : bytes) {
                                         if (board.feed(byte, frames.data()) == 0) continue;
                                         const std::int64_t block =
                                             fogcomp::series::sample_number(recording, row++) /
                                             kSamplesPerBlock;
                                         if (!board.last().compensated_valid()) continue;
                                         auto& [sum, count] = sums[block];
                                         sum += std::ldexp(board.last().drift.raw(), -10);
                                         ++count;
                                       }
                                     });
  std::map<std::int64_t, double> drift;
  for (const auto& [block, of_samples] : sums) {
    drift[block] = of_samples.first / of_samples.second;
  }
  return drift;
}

// Largest difference between board and host over all blocks in which the host has a drift, deg/h.
double worst_difference(const fogcomp::model::Model& model) {
  const fogcomp::recording::Recording recording = recording_with_gaps();
  const auto board = board_drift(model, recording);
  const fogcomp::series::BlockSeries series = fogcomp::series::make_blocks(recording);
  fogcomp::model::RealDriftModel real(model, series.block_s);
  double worst = 0;
  std::size_t compared = 0;
  fogcomp::series::run_blocks(series, real, [&](const fogcomp::series::BlockSeries::Block& block) {
    const auto found = board.find(block.number);
    ASSERT_NE(found, board.end()) << "the board has no drift in block " << block.number;
    worst = std::max(worst, std::abs(found->second - real.drift_dph()));
    ++compared;
  });
  EXPECT_GT(compared, 10600U);
  return worst;
}

TEST(RecordingOnBoard, HasTheDriftThatFitAndCompareSeeAlsoAroundGaps) {
  fogcomp::model::Model model = fog::test::all_effects_model();
  const auto sees_rate = [](const auto& term) {
    return has(fogcomp::model::info_of(term).needs, fog::Input::input_rate);
  };
  model.terms.erase(std::remove_if(model.terms.begin(), model.terms.end(), sees_rate),
                    model.terms.end());
  EXPECT_LE(worst_difference(model), 6.0 / 1024);
}

// The board's scale factor effects use the measured rate, here 1.2 deg/h from the true one: with
// 300 ppm/degC over 40 degC a difference of 0.014 deg/h.
TEST(RecordingOnBoard, HasTheScaleFactorOfTheMeasuredRate) {
  EXPECT_LE(worst_difference(fog::test::all_effects_model()), 0.02);
}

}  // namespace
