#include <array>
#include <cstddef>
#include <cstdint>

#include "app/crash_line.hpp"
#include "app/health.hpp"
#include "app/own_temperature.hpp"
#include "app/pipeline.hpp"
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

void send_compensated(Pipeline& pipeline, std::uint8_t byte) {
  std::array<std::uint8_t, kMostOutputBytes> frames;
  const std::size_t size = pipeline.feed(byte, frames.data(), with_own_temperature, sample_time);
  if (size == 0) return;
  hal::write_output_stream(frames.data(), size);
  count_health(pipeline.last());
  test_on();
}

}  // namespace

void run() {
  platform::start_board();
  self_test().run_all();
  announce(platform::describe_board(), hal::reset_report());
  start_own_thermometer();
  hal::start_watchdog();
  std::array<std::uint8_t, 64> chunk;
  Pipeline& product = pipeline();
  for (;;) {
    const std::size_t size = hal::read_sensor_stream(chunk.data(), chunk.size());
    if (size == 0) hal::wait_for_event();
    for (std::size_t i = 0; i < size; ++i) send_compensated(product, chunk[i]);
    answer_requests();
    if (hal::milliseconds() - tested_ms >= kIdleMs) test_on();
    advance_own_thermometer();
    hal::kick_watchdog();  // here and nowhere else: kicked means that the loop went round
  }
}

}  // namespace fog::app
