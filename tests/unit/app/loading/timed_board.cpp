#include "timed_board.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/bytes/crc.hpp"
#include "core/frames/output_bytes.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/health/image_seal.hpp"
#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "hal/memory_map.hpp"
#include "hal/model_memory.hpp"
#include "hal/processor.hpp"
#include "hal/rate_sink.hpp"
#include "hal/request_source.hpp"
#include "hal/reset_report.hpp"
#include "hal/sample_source.hpp"
#include "hal/service_strap.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/shared/stack.hpp"

namespace fog::test {

TimedBoard board;

void TimedBoard::pass(std::uint64_t us) {
  for (const std::uint64_t until = now_us + us; now_us < until;) {
    const std::uint64_t next = next_sample_us();
    now_us = std::min(until, next);
    if (now_us >= end_us) throw EndOfTest();
    watchdog_bit = watchdog_bit || now_us - kicked_us > std::uint64_t{patience_ms} * 1000;
    if (now_us == next && sends_samples) receive_sample();
  }
}

void TimedBoard::wait() {
  pass(std::min((now_us / 1000 + 1) * 1000, next_sample_us()) - now_us);
}

void TimedBoard::run_for(std::uint32_t ms) {
  end_us = now_us + std::uint64_t{ms} * 1000;
  EXPECT_THROW(fog::app::run(), EndOfTest);
  EXPECT_FALSE(watchdog_bit);
}

void TimedBoard::receive_sample() {
  constexpr std::size_t kBuffer = 512;
  static std::uint16_t sequence = 0;
  ++sequence;
  ++samples;
  const auto frame =
      fog::encode_sensor_frame({sequence, 700 + sequence % 7 * 200, 25 << 16, true, true});
  if (line.size() + frame.size() <= kBuffer) line.insert(line.end(), frame.begin(), frame.end());
}

namespace {

std::vector<std::uint8_t> sealed_image() {
  std::vector<std::uint8_t> image(1000, 0x5A);
  const auto seal = fog::seal_of(fog::crc32(image.data(), image.size(), fog::kImageCrcStart));
  image.insert(image.end(), seal.begin(), seal.end());
  return image;
}
std::array<std::uint32_t, 64> tested_memory;

std::size_t take(std::deque<std::uint8_t>& from, std::uint8_t* to, std::size_t capacity) {
  std::size_t size = 0;
  for (; size < capacity && !from.empty(); ++size) {
    to[size] = from.front();
    from.pop_front();
  }
  return size;
}

}  // namespace
}  // namespace fog::test

namespace fog {
namespace hal {

using test::board;
using test::take;

std::uint32_t milliseconds() {
  return board.now_ms();
}
bool clock_is_accurate() {
  return true;
}
bool clock_keeps_time() {
  return true;
}
void wait_for_event() {
  board.wait();
}
void hold_interrupts() {}
void release_interrupts() {}
void try_another_speed() {}
void report_good_run() {}
void write_console(const char*) {}
bool service_strap_closed() {
  return board.strap_closed;
}
std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity) {
  constexpr std::uint64_t kPassUs = 20;
  board.pass(kPassUs);
  return take(board.line, destination, capacity);
}
std::size_t read_requests(std::uint8_t* destination, std::size_t capacity) {
  return take(board.requests, destination, capacity);
}
void write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  board.sent.emplace_back(bytes, bytes + size);
  board.pass(board.output_line.us_of(size));  // polled: the processor waits
}
void kick_watchdog() {
  board.kicked_us = board.now_us;
}
void start_watchdog(std::uint32_t timeout_ms) {
  board.patience_ms = timeout_ms;
  kick_watchdog();
}
MemoryMap memory_map() {
  static const std::vector<std::uint8_t> image = test::sealed_image();
  return {image.data(), image.data() + image.size(), test::tested_memory.data(),
          test::tested_memory.data() + test::tested_memory.size(), test::tested_memory.data()};
}
const ResetReport& reset_report() {
  static ResetReport report{ResetCause::power_on, {}, {}};
  report.counts.faults = board.faults;
  return report;
}
ProcessorNumber processor_number() {
  return {1, 2, 3};
}
std::array<ModelMemory, 2> model_memories() {
  const auto memory = [](std::size_t slot) {
    return ModelMemory{board.flash.memory(slot).data, board.flash.memory(slot).size};
  };
  return {memory(0), memory(1)};
}
bool erase_model_memory(std::size_t slot) {
  board.stalled = true;  // milliseconds stand still as well
  board.patience_ms = 6000;
  return board.flash.erase(slot);
}
bool program_model_memory(std::size_t slot, std::size_t at, const std::uint32_t* words,
                          std::size_t count) {
  return board.flash.program(slot, at, words, count);
}

}  // namespace hal

namespace platform {

void start_board() {}
void open_lines(SerialLine, SerialLine output) {
  test::board.output_line = output;
}
BoardDescription describe_board() {
  return {"test", 0, "test", false, true};
}
void restart_board() {
  throw test::EndOfTest();
}
void restart_on_request() {
  throw test::Restart();
}
std::size_t stack_bytes_reserved() {
  return 0;
}
std::size_t stack_bytes_unused() {
  return 0;
}

}  // namespace platform
}  // namespace fog
