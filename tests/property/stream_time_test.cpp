// A captured stream has the same time on the board and on the host: the board's block clock,
// through lost, late, swapped and repeated samples and a restarted demodulator, equals the
// recording's time column.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "board/host_compensator.hpp"
#include "core/frames/sensor_frame.hpp"
#include "recording/recording.hpp"
#include "support/sample_models.hpp"
#include "support/typical_effects.hpp"
#include "unit/recording/temporary_file.hpp"

namespace {

constexpr double kDriftPerSecondDph = 0.25;

// A board with blocks of one sample, 1 s, whose drift is the time on its block clock.
fogcomp::model::Model clock_model() {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.network = {};
  fogcomp::model::EffectTerm clock = fog::test::written_term("clock = t");
  clock.coefficients_dph = {std::ldexp(kDriftPerSecondDph, clock.expression->scale_log2)};
  model.terms = {clock};
  return model;
}

// Sequence numbers in the order in which they arrive.
std::vector<std::uint16_t> random_arrivals(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned limit) { return static_cast<std::uint32_t>(random() % limit); };
  std::vector<std::uint16_t> arrivals;
  const auto send = [&](std::uint32_t sequence) {
    arrivals.push_back(static_cast<std::uint16_t>(sequence));
  };
  std::uint32_t next = below(65536);
  for (int i = 0; i < 3000; ++i) {
    switch (below(60)) {
      case 0:  // lost
        next += below(20) == 0 ? below(32767) : below(300);
        break;
      case 1:  // repeated, late
        send(next - 1 - below(500));
        break;
      case 2:  // swapped
        send(next + 1);
        send(next);
        next += 2;
        break;
      case 3:  // restarted
        if (below(5) == 0) next = below(2) == 0 ? 0 : below(65536);
        break;
      default:
        break;
    }
    send(next++);
  }
  return arrivals;
}

fog::SensorSample sample_of(std::uint16_t sequence) {
  return {sequence, 1000 + 37 * (sequence % 11), 25 * 65536, true, true};
}

// Seconds on the board's clock before each sample that counts.
std::vector<double> board_times(const std::vector<std::uint16_t>& arrivals) {
  const fogcomp::board::BoardTable table = fogcomp::board::make_board_table(clock_model(), {1.0});
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
  fogcomp::board::HostCompensator board(parameters, fog::IntegrityToken::not_needed());
  std::vector<double> times;
  for (const std::uint16_t sequence : arrivals) {
    const double drift_dph = std::ldexp(board.process(sample_of(sequence)).drift.raw(), -10);
    times.push_back(std::round(drift_dph / kDriftPerSecondDph));
  }
  return times;
}

TEST(StreamTime, IsWhatTheBoardsBlockClockCounts) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const std::vector<std::uint16_t> arrivals = random_arrivals(seed);
    std::string bytes;
    for (const std::uint16_t sequence : arrivals) {
      const fog::SensorFrame frame = fog::encode_sensor_frame(sample_of(sequence));
      bytes.append(reinterpret_cast<const char*>(frame.data()), frame.size());
    }
    fogcomp::recording::ReadOptions options;
    options.stream_rate_hz = 1;
    const fogcomp::recording::Recording recording = fogcomp::recording::read_recording(
        fogcomp::recording::temporary_file("arrivals.bin", bytes), options);

    // The clock advances only with samples that count: each of its readings but the last belongs to
    // a row.
    std::vector<double> board = board_times(arrivals);
    EXPECT_EQ(board.front(), 0);
    board.erase(std::unique(board.begin(), board.end()), board.end());
    std::vector<double> host{0};
    for (const double time_s : recording.time_s) {
      host.push_back(time_s - recording.time_s[0] + 1);
    }
    if (board.size() < host.size()) host.pop_back();  // read by no later sample
    EXPECT_EQ(host, board) << "seed " << seed;
    EXPECT_GT(recording.capture->late_samples, 30U);
    EXPECT_GT(recording.capture->missing_samples, 1000U);
  }
}

}  // namespace
