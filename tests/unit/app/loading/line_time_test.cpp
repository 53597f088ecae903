// The product's main loop at the sample rates and frames that the output line allows, with a clock
// that keeps time. Each case runs in a process of its own, because a board reads its table once.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "board/table_files.hpp"
#include "core/frames/compact_frame.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/health_request.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/signal/status.hpp"
#include "support/sample_models.hpp"
#include "timed_board.hpp"

namespace {

using fog::OutputSelection;
using fog::test::board;

struct Case {
  double rate_hz;
  OutputSelection output;
  bool sends_samples = true;
  std::uint32_t faults = 0;
  fog::SerialLine output_line{};
};

void insert_table(const Case& run) {
  fogcomp::board::BoardSettings settings = fog::test::lenient_board();
  settings.sample_rate_hz = run.rate_hz;
  settings.output = run.output;
  settings.output_line = run.output_line;
  const auto table = fogcomp::board::make_board_table(fog::test::paper_like_model(), settings);
  const std::string bytes = fogcomp::board::slot_bytes(table, 1, "test");
  std::memcpy(board.flash.slot(0).data(), bytes.data(), bytes.size());
  board.period_us = static_cast<std::uint32_t>(table.words[fog::kProcessorAt + 3]);
  board.sends_samples = run.sends_samples;
  board.faults = run.faults;
}

// Whether the frame, the last of an answer, is valid as far as the line is concerned.
bool is_of_sample(const std::vector<std::uint8_t>& sent, OutputSelection output) {
  if (output == OutputSelection::kvh) return true;
  const std::size_t status_at = sent.size() - fog::kCompactFrameBytes + 20;
  std::uint32_t status = 0;
  std::memcpy(&status, &sent[status_at], sizeof status);
  return (status & static_cast<std::uint32_t>(fog::Status::no_samples)) == 0;
}

// Runs for 5 s and ends the process: code 0 if there are `per_period` answers per sample period
// (within 1 %), all of samples or none, and the watchdog never bit.
[[noreturn]] void run_board(const Case& run) {
  constexpr std::uint32_t kRunMs = 5000;
  insert_table(run);
  board.run_for(kRunMs);
  std::size_t of_samples = 0;
  for (const auto& sent : board.sent) of_samples += is_of_sample(sent, run.output) ? 1U : 0U;
  const std::uint32_t period_us = run.faults == 0 ? board.period_us : 5000;
  const double expected = 1000.0 * kRunMs / period_us;
  const auto answers = static_cast<double>(board.sent.size());
  std::fprintf(stderr, "%zu answers, %zu of %u samples, %.0f expected\n", board.sent.size(),
               of_samples, board.samples, expected);
  const bool right_share = run.sends_samples
                               ? board.sent.size() - of_samples <= 2 && answers <= expected + 3
                               : run.output == OutputSelection::kvh || of_samples == 0;
  const bool right_number = answers >= 0.99 * expected - 3 && answers <= 1.01 * expected + 3;
  std::exit(right_share && right_number && !board.watchdog_bit ? 0 : 1);
}

void expect_runs(const Case& run) {
  EXPECT_EXIT(run_board(run), testing::ExitedWithCode(0), "") << run.rate_hz << " Hz";
}

class LineTimeDeathTest : public testing::TestWithParam<double> {};

TEST_P(LineTimeDeathTest, GoodSamples_AtAnyPeriod_NoOtherFrame) {
  const double rate_hz = GetParam();
  if (rate_hz <= 1400) expect_runs({rate_hz, OutputSelection::both});
  if (rate_hz <= 3000) expect_runs({rate_hz, OutputSelection::compact});
  if (rate_hz <= 2400) expect_runs({rate_hz, OutputSelection::kvh});
}

TEST_P(LineTimeDeathTest, NoSamples_AtAnyPeriod_OneFramePerPeriod) {
  const double rate_hz = GetParam();
  if (rate_hz <= 1400) expect_runs({rate_hz, OutputSelection::both, false});
  if (rate_hz <= 2400) expect_runs({rate_hz, OutputSelection::kvh, false});
}

INSTANTIATE_TEST_SUITE_P(Rates, LineTimeDeathTest,
                         testing::Values(10, 200, 333, 500, 625, 750, 800, 1000, 1100, 1400, 1500,
                                         1900, 2300, 2400, 3000));

constexpr fog::SerialLine kFastest(4'147'200);
constexpr fog::SerialLine kSlowest(9'600 | 3U << fog::SerialLine::kStopBit);  // 8E2

TEST(OtherLinesDeathTest, FiveKilohertz_OnTheFastestLine_Runs) {
  for (const OutputSelection output : {OutputSelection::kvh, OutputSelection::both}) {
    for (const bool sends_samples : {true, false}) {
      expect_runs({5000, output, sends_samples, 0, kFastest});
    }
  }
}

TEST(OtherLinesDeathTest, SlowestLine_FramesThatJustFit_Runs) {
  for (const bool sends_samples : {true, false}) {
    expect_runs({12.4, OutputSelection::both, sends_samples, 0, kSlowest});
    expect_runs({22, OutputSelection::kvh, sends_samples, 0, kSlowest});
  }
}

// Whether it is a health record that says how late the rate is, and what a sample takes.
bool tells_delay(const std::vector<std::uint8_t>& sent) {
  fog::HealthRecord record;
  return sent.size() == fog::kHealthResponseBytes &&
         fog::decode_health_response(sent.data(), record) &&
         (record[fog::HealthWord::rate_delay] & 0xFFFFU) == fog::denoise_delay(16, 5) &&
         record[fog::HealthWord::sample_period] == board.period_us;
}

// Requests without a pause, each of which is answered by 112 bytes: 140 ms.
[[noreturn]] void run_requests() {
  insert_table({12.4, OutputSelection::both, true, 0, kSlowest});
  for (int i = 0; i < 10; ++i) {
    board.requests.insert(board.requests.end(), fog::kHealthRequest.begin(),
                          fog::kHealthRequest.end());
  }
  board.run_for(5000);
  std::size_t records = 0;
  for (const auto& sent : board.sent) records += tells_delay(sent) ? 1U : 0U;
  std::fprintf(stderr, "%zu records, watchdog %u ms\n", records, board.patience_ms);
  std::exit(records == 10 && !board.watchdog_bit ? 0 : 1);
}

TEST(OtherLinesDeathTest, Requests_OnTheSlowestLine_WatchdogLetsThemPass) {
  EXPECT_EXIT(run_requests(), testing::ExitedWithCode(0), "");
}

TEST(SafeModeDeathTest, Frames_AnyTable_PeriodOfItsOwn) {
  for (const double rate_hz : {1.0, 200.0, 2400.0}) {
    expect_runs({rate_hz, OutputSelection::kvh, true, 5});
  }
}

// A user who has entered the configuration mode and is cut off. Beside the answer to his command
// the board has sent what its tests at the start have found.
[[noreturn]] void run_configuration() {
  fogcomp::board::BoardSettings settings = fog::test::lenient_board();
  settings.output_options = fog::kAnswersKvhCommands;
  const auto table = fogcomp::board::make_board_table(fog::test::paper_like_model(), settings);
  const std::string bytes = fogcomp::board::slot_bytes(table, 1, "test");
  std::memcpy(board.flash.slot(0).data(), bytes.data(), bytes.size());
  const std::string command = "=CONFIG,1\r";
  board.requests.assign(command.begin(), command.end());
  board.run_for(9'900);
  const std::size_t within = board.sent.size();
  board.run_for(1'100);
  std::fprintf(stderr, "%zu answers, then %zu\n", within, board.sent.size() - within);
  const std::vector<std::uint8_t> all_passed{0xFE, 0x81, 0,    0xAA, 0x7F, 0x7F,
                                             0x7F, 0x7F, 0x7F, 0x7F, 0x23};
  const bool reported = !board.sent.empty() && board.sent[0] == all_passed;
  std::exit(reported && within == 2 && board.sent.size() - within >= 190 ? 0 : 1);
}

TEST(ConfigurationDeathTest, NoFurtherCommand_EndsAfterTenSeconds) {
  EXPECT_EXIT(run_configuration(), testing::ExitedWithCode(0), "");
}

}  // namespace
