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

bool is_in_short_gap(int i) {
  return (i > 5003 && i < 5008) || (i > 20004 && i < 20057);
}

// Three hours of ramps with all inputs in motion; gaps within a block and over blocks, and a longer
// one: `missing_s`.
fogcomp::recording::Recording recording_with_gaps(int missing_s) {
  fogcomp::recording::Recording recording;
  recording.file = "gaps.csv";
  recording.period_s = kPeriodS;
  const int missing = 10 * missing_s + 3;
  for (int i = 0; i < 108000 + missing; ++i) {
    if (is_in_short_gap(i) || (i > 60000 && i < 60000 + missing)) continue;
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

enum class Blocks { all, settled };

// Mean drift of the board in each block, by the block's number: effects that follow the input rate
// differ from sample to sample. Without those that the board calls invalid, or not settled.
std::map<std::int64_t, double> board_drift(const fogcomp::model::Model& model,
                                           const fogcomp::recording::Recording& recording,
                                           Blocks blocks) {
  const auto leaves_out = [&](const fog::OutputSample& output) {
    return !output.compensated_valid() ||
           (blocks == Blocks::settled && has_any(output.status, fog::Status::thermal_settling));
  };
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
                                         if (leaves_out(board.last())) continue;
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

// Largest difference between board and host over the blocks, deg/h. The host has a drift in no
// other ones than the board; `least`: how many must have one.
double worst_difference(const fogcomp::model::Model& model, Blocks blocks, int missing_s,
                        std::size_t least) {
  const fogcomp::recording::Recording recording = recording_with_gaps(missing_s);
  const auto board = board_drift(model, recording, blocks);
  const fogcomp::series::BlockSeries series = fogcomp::series::make_blocks(recording);
  fogcomp::model::RealDriftModel real(model, series.block_s);
  double worst = 0;
  std::size_t compared = 0;
  fogcomp::series::run_blocks(series, real, [&](const fogcomp::series::BlockSeries::Block& block) {
    const auto found = board.find(block.number);
    if (found == board.end()) {
      ASSERT_EQ(blocks, Blocks::settled) << "the board has no drift in block " << block.number;
      return;
    }
    worst = std::max(worst, std::abs(found->second - real.drift_dph()));
    ++compared;
  });
  EXPECT_GE(compared, least);
  return worst;
}

TEST(RecordingOnBoard, HasTheDriftThatFitAndCompareSeeAlsoAroundGaps) {
  fogcomp::model::Model model = fog::test::all_effects_model();
  const auto sees_rate = [](const auto& term) {
    return has(fogcomp::model::info_of(term).needs, fog::Input::input_rate);
  };
  model.terms.erase(std::remove_if(model.terms.begin(), model.terms.end(), sees_rate),
                    model.terms.end());
  EXPECT_LE(worst_difference(model, Blocks::all, 2000, 10600), 6.0 / 1024);
}

// A logger that wrote nothing for two minutes: the gyro went on, and a board that samples without a
// gap has settled.
TEST(RecordingOnBoard, HasTheDriftAfterAGapOnceItHasSettled) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.network = {};
  EXPECT_LE(worst_difference(model, Blocks::settled, 123, 9900), 6.0 / 1024);
}

// The board's scale factor effects use the measured rate, here 1.2 deg/h from the true one: with
// 300 ppm/degC over 40 degC a difference of 0.014 deg/h.
TEST(RecordingOnBoard, HasTheScaleFactorOfTheMeasuredRate) {
  EXPECT_LE(worst_difference(fog::test::all_effects_model(), Blocks::all, 2000, 10600), 0.02);
}

}  // namespace
