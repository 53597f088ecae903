#include <array>
#include <cstddef>
#include <cstdint>

#include "app/crash_line.hpp"
#include "app/health.hpp"
#include "app/own_temperature.hpp"
#include "app/pipeline.hpp"
#include "core/pipeline/silence_clock.hpp"
#include "hal/clock.hpp"
#include "hal/rate_sink.hpp"
#include "hal/reset_report.hpp"
#include "hal/sample_source.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/text_line.hpp"

// The product: sensor stream in, output stream out, for as long as there is power.
namespace fog::app {
namespace {

// The last but one line says whether the weights are good, the last whether the image is. Without
// them the board still answers every sample, with a rate that is not valid: a user sees a fault
// rather than silence.
void announce(const platform::BoardDescription& board, const hal::ResetReport& reset) {
  platform::TextLine line;
  line.text("fogcomp ").text(board.name).text(" ready, clock ").decimal(board.core_clock_hz);
  line.text(" Hz, reset cause ").text(describe(reset.cause));
  line.text(", clock from ").text(board.clock_source).text("\r\n");
  hal::write_console(line.c_str());
  if (board.clock_is_fallback) hal::write_console("FALLBACK CLOCK\r\n");
  if (!board.restarts_when_power_dips) hal::write_console("NO BROWN-OUT RESET\r\n");
  announce_crash(reset.last_crash);
  platform::TextLine weights;
  weights.text("model ").hex(model().parameters.provenance).text(": ");
  hal::write_console(weights.text(describe(model().error)).text("\r\n").c_str());
  const bool intact = self_test().start_crc() == kIntactImage;
  hal::write_console(intact ? "image: good\r\n" : "image: DAMAGED, no rate is valid\r\n");
  if (!self_test().memory_good()) hal::write_console("memory: FAILS, no rate is valid\r\n");
}

// A board that is sent nothing, or no longer understands what it is sent, tests itself all the
// same.
constexpr std::uint32_t kIdleMs = 8;
std::uint32_t tested_ms = 0;

void test_on() {
  self_test().step();
  tested_ms = hal::milliseconds();
}

SampleTime sample_time() {
  return {hal::clock_is_accurate(), hal::milliseconds()};
}

using Frames = std::array<std::uint8_t, kMostOutputBytes>;

void send(const Frames& frames, std::size_t size) {
  hal::write_output_stream(frames.data(), size);
  count_health(pipeline().last());
  test_on();
}

void send_compensated(std::uint8_t byte, SilenceClock& silence) {
  Frames frames;
  const std::size_t size = pipeline().feed(byte, frames.data(), with_own_temperature, sample_time);
  if (size == 0) return;
  silence.restart(hal::milliseconds());
  send(frames, size);
}

// Where time does not pass as it should nobody can say that samples are late.
void break_silence(SilenceClock& silence) {
  while (silence.due(hal::milliseconds())) {
    if (!hal::clock_keeps_time()) continue;
    Frames frames;
    send(frames, pipeline().answer_silence(frames.data()));
  }
}

// The watchdog comes first: a start that hangs is a board that is silent for ever.
void start() {
  hal::start_watchdog(hal::kWatchdogStartMs);
  platform::start_board();
  hal::kick_watchdog();
  self_test().run_all();
  hal::kick_watchdog();
  announce(platform::describe_board(), hal::reset_report());
  start_own_thermometer();
  hal::start_watchdog(hal::kWatchdogLoopMs);
}

}  // namespace

void run() {
  start();
  std::array<std::uint8_t, 64> chunk;
  SilenceClock silence(model().parameters.acquisition.sample_period_us, hal::milliseconds());
  for (;;) {
    const std::size_t size = hal::read_sensor_stream(chunk.data(), chunk.size());
    if (size == 0) hal::wait_for_event();
    for (std::size_t i = 0; i < size; ++i) send_compensated(chunk[i], silence);
    break_silence(silence);
    answer_requests();
    if (hal::milliseconds() - tested_ms >= kIdleMs) test_on();
    advance_own_thermometer();
    hal::kick_watchdog();  // nowhere else in the loop: kicked means that it went round
  }
}

}  // namespace fog::app
