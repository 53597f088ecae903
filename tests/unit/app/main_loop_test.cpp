// The product's main loop, as flashed. This test is the board: it supplies the demodulator's data,
// and time passes where the loop waits.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "core/bytes/crc.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/health/image_seal.hpp"
#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "hal/memory_map.hpp"
#include "hal/processor.hpp"
#include "hal/rate_sink.hpp"
#include "hal/request_source.hpp"
#include "hal/reset_report.hpp"
#include "hal/sample_source.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/shared/stack.hpp"

namespace {

struct Frame {
  std::uint32_t at_ms;
  std::vector<std::uint8_t> bytes;

  bool marks_valid() const { return bytes[28] != 0; }
  bool has_right_crc() const {
    std::uint32_t sent = 0;
    for (std::size_t i = 32; i < 36; ++i) sent = sent << 8U | bytes[i];
    return sent == fog::crc32(bytes.data(), 32, fog::kCrc32Initial);
  }
};

struct EndOfTest {};

// One instance, because there is one board.
struct Board {
  std::uint32_t now_ms = 0xFFFFFF00U;  // about to wrap
  std::uint32_t end_ms = 0;
  bool keeps_time = true;
  /// Whether the demodulator sends a sample in this millisecond.
  std::function<bool(std::uint32_t ms)> sends = [](std::uint32_t) { return false; };
  std::deque<std::uint8_t> line;
  std::vector<Frame> frames;
  std::vector<std::string> calls;
  std::uint32_t faults = 0;  // restarts before
  int good_runs = 0;
  int other_speeds = 0;

  void tick() {
    ++now_ms;
    if (now_ms == end_ms) throw EndOfTest();
    static std::uint16_t sequence = 0;
    if (now_ms % 5 == 0) ++sequence;  // of a sample, whether it is sent or lost
    if (!sends(now_ms)) return;
    const auto frame =
        fog::encode_sensor_frame({sequence, 700 + sequence % 7 * 200, 25 << 16, true, true});
    line.insert(line.end(), frame.begin(), frame.end());
  }
};

Board* board = nullptr;

std::vector<std::uint8_t> sealed_image() {
  std::vector<std::uint8_t> image(1000, 0x5A);
  const auto seal = fog::seal_of(fog::crc32(image.data(), image.size(), fog::kImageCrcStart));
  image.insert(image.end(), seal.begin(), seal.end());
  return image;
}

std::array<std::uint32_t, 64> tested_memory;

// Runs the loop for this time.
void run_for(Board& here, std::uint32_t ms) {
  board = &here;
  here.end_ms = here.now_ms + ms;
  EXPECT_THROW(fog::app::run(), EndOfTest);
}

}  // namespace

// Functions that the application requires of a board.
namespace fog {
namespace hal {

std::uint32_t milliseconds() {
  return board->now_ms;
}
bool clock_is_accurate() {
  return board->keeps_time;
}
bool clock_keeps_time() {
  return board->keeps_time;
}
void wait_for_event() {
  board->tick();
}
void hold_interrupts() {}
void release_interrupts() {}
void write_console(const char*) {
  board->calls.emplace_back("console");
}
std::size_t read_requests(std::uint8_t*, std::size_t) {
  return 0;
}
void kick_watchdog() {}
void start_watchdog(std::uint32_t timeout_ms) {
  board->calls.push_back("watchdog " + std::to_string(timeout_ms));
}

std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity) {
  std::size_t size = 0;
  for (; size < capacity && !board->line.empty(); ++size) {
    destination[size] = board->line.front();
    board->line.pop_front();
  }
  return size;
}

void write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  board->frames.push_back({board->now_ms, {bytes, bytes + size}});
}

MemoryMap memory_map() {
  static const std::vector<std::uint8_t> image = sealed_image();
  return {image.data(), image.data() + image.size(), tested_memory.data(),
          tested_memory.data() + tested_memory.size(), tested_memory.data()};
}

const ResetReport& reset_report() {
  static ResetReport report{ResetCause::power_on, {}, {}};
  report.counts.faults = board->faults;
  return report;
}
ProcessorNumber processor_number() {
  return {1, 2, 3};
}
void report_good_run() {
  ++board->good_runs;
}
void try_another_speed() {
  ++board->other_speeds;
}

}  // namespace hal

namespace platform {

void start_board() {
  board->calls.emplace_back("board");
}
void open_lines(SerialLine, SerialLine) {
  board->calls.emplace_back("lines");
}
BoardDescription describe_board() {
  return {"test", 0, "test", false, true};
}
void restart_board() {
  throw EndOfTest();
}
std::size_t stack_bytes_reserved() {
  return 0;
}
std::size_t stack_bytes_unused() {
  return 0;
}

}  // namespace platform
}  // namespace fog

namespace {

TEST(MainLoop, StartsTheWatchdogBeforeAnythingElseAndTightensItBeforeTheLoop) {
  Board here;
  run_for(here, 20);
  ASSERT_GE(here.calls.size(), 3U);
  EXPECT_EQ(here.calls[0], "watchdog 500");
  EXPECT_EQ(here.calls[1], "board");
  EXPECT_EQ(here.calls[2], "lines");
  EXPECT_EQ(here.calls.back(), "watchdog 106");
}

TEST(MainLoop, AnswersEverySampleAtOnceAndNothingElse) {
  Board here;
  here.sends = [](std::uint32_t ms) { return ms % 5 == 0; };
  run_for(here, 5000);
  EXPECT_NEAR(static_cast<double>(here.frames.size()), 1000, 2);
  for (const Frame& frame : here.frames) EXPECT_EQ(frame.at_ms % 5, 0U);
}

// Samples are lost, the demodulator is late, a frame is damaged, or the demodulator fails for good.
TEST(MainLoop, BreaksASilenceWithinTwoPeriodsAndGoesOnAtTheSampleRate) {
  Board here;
  const std::uint32_t start = here.now_ms;
  const auto is_silent = [start](std::uint32_t ms) {
    const std::uint32_t since = ms - start;
    return since < 300 || (since >= 2000 && since < 3000) || since >= 4000;
  };
  here.sends = [&](std::uint32_t ms) { return ms % 5 == 0 && !is_silent(ms); };
  run_for(here, 6000);
  EXPECT_NEAR(static_cast<double>(here.frames.size()), 1200, 10);
  std::uint32_t before = start;
  int silent = 0;
  for (const Frame& frame : here.frames) {
    EXPECT_LE(frame.at_ms - before, 12U) << frame.at_ms - start;
    before = frame.at_ms;
    if (!is_silent(frame.at_ms)) continue;
    ++silent;
    EXPECT_FALSE(frame.marks_valid());
    EXPECT_TRUE(frame.has_right_crc());
  }
  EXPECT_NEAR(silent, 660, 10);
  // It counts samples: a silence has answered all but the first one or two that were lost.
  int counted = 0;
  for (std::size_t i = 1; i < here.frames.size(); ++i) {
    const int step = (here.frames[i].bytes[29] - here.frames[i - 1].bytes[29] + 128) % 128;
    EXPECT_GE(step, 1) << i;
    EXPECT_LE(step, 3) << i;
    counted += step;
  }
  EXPECT_NEAR(counted, 1200, 5);
}

TEST(MainLoop, ABoardThatFailsAgainAndAgainOnlySaysThatNothingIsValid) {
  Board here;
  here.faults = 5;
  here.sends = [](std::uint32_t ms) { return ms % 5 == 0; };
  run_for(here, 3000);
  EXPECT_NEAR(static_cast<double>(here.frames.size()), 600, 5);
  for (const Frame& frame : here.frames) {
    EXPECT_FALSE(frame.marks_valid());
    EXPECT_TRUE(frame.has_right_crc());
  }
  EXPECT_EQ(here.good_runs, 0);
}

TEST(MainLoop, FaultsAreForgottenAfterAMinute) {
  Board here;
  here.now_ms = 0;
  here.faults = 4;
  here.sends = [](std::uint32_t ms) { return ms % 5 == 0; };
  run_for(here, 59'900);
  EXPECT_EQ(here.good_runs, 0);
  here.now_ms = 0;
  here.line.clear();
  run_for(here, 61'000);
  EXPECT_EQ(here.good_runs, 1);
}

TEST(MainLoop, TriesAnotherSpeedWhereWhatComesIsNoFrame) {
  Board here;
  run_for(here, 3000);
  EXPECT_EQ(here.other_speeds, 0) << "nothing comes";
  here.sends = [&](std::uint32_t) {
    here.line.push_back(0x5A);
    return false;
  };
  run_for(here, 3000);
  EXPECT_NEAR(here.other_speeds, 6, 1) << "every half second";
}

TEST(MainLoop, TakesNothingForASilenceWhereTimeDoesNotPassAsItShould) {
  Board here;
  here.keeps_time = false;
  run_for(here, 3000);
  EXPECT_TRUE(here.frames.empty());
}

}  // namespace
