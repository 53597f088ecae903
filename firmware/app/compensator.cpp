#include <array>
#include <cstddef>
#include <cstdint>

#include "app/crash_line.hpp"
#include "app/health.hpp"
#include "app/kept_state.hpp"
#include "app/load.hpp"
#include "app/loop_watchdog.hpp"
#include "app/own_temperature.hpp"
#include "app/pipeline.hpp"
#include "build_identity.h"
#include "core/pipeline/silence_clock.hpp"
#include "hal/clock.hpp"
#include "hal/processor.hpp"
#include "hal/rate_sink.hpp"
#include "hal/reset_report.hpp"
#include "hal/sample_source.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/text_line.hpp"

// The product: sensor stream in, output stream out.
namespace fog::app {
namespace {

// One function per line, so that their texts are not on the stack at the same time.
[[gnu::noinline]] void announce_identity(const Model& used) {
  platform::TextLine line;
  line.text("firmware " FOG_BUILD_VERSION " ").hex(FOG_BUILD_SOURCES).text(", processor");
  for (const std::uint32_t word : hal::processor_number()) line.text(" ").hex(word);
  line.text("\r\nmodel ").hex(used.parameters.provenance);
  const bool has_serial = used.error == ModelError::none && *used.serial() != 0;
  if (has_serial) line.text(" of ").text(used.serial());
  hal::write_console(line.text(": ").text(describe(used.error)).text("\r\n").c_str());
}

[[gnu::noinline]] void announce_board(const platform::BoardDescription& board,
                                      hal::ResetCause reset_cause) {
  platform::TextLine line;
  line.text("fogcomp ").text(board.name).text(" ready, clock ").decimal(board.core_clock_hz);
  line.text(" Hz, reset cause ").text(describe(reset_cause));
  line.text(", clock from ").text(board.clock_source).text("\r\n");
  hal::write_console(line.c_str());
}

// The last but one line reports the weights, the last one the image. If either is bad, the board
// still answers every sample, with an invalid rate, so that the user sees a fault and not silence.
[[gnu::noinline]] void announce(const platform::BoardDescription& board,
                                const hal::ResetReport& reset) {
  announce_board(board, reset.cause);
  if (board.clock_is_fallback) hal::write_console("FALLBACK CLOCK\r\n");
  if (!board.restarts_when_power_dips) hal::write_console("NO BROWN-OUT RESET\r\n");
  announce_crash(reset.last_crash);
  announce_identity(model());
  const bool intact = self_test().start_crc() == kIntactImage;
  hal::write_console(intact ? "image: good\r\n" : "image: DAMAGED, no rate is valid\r\n");
  if (!self_test().memory_good()) hal::write_console("memory: FAILS\r\n");
}

// Period of the self-test while no sample comes.
constexpr std::uint32_t kIdleMs = 8;
std::uint32_t tested_ms = 0;

void continue_self_test() {
  self_test().step();
  tested_ms = hal::milliseconds();
}

SampleTime sample_time() {
  return {hal::clock_is_accurate(), hal::milliseconds()};
}

using Frames = std::array<std::uint8_t, kMaxOutputBytes>;

void send(const Frames& frames, std::size_t size) {
  if (sends_frames()) hal::write_output_stream(frames.data(), size);
  count_health(pipeline().last());
}

void send_compensated(std::uint8_t byte, SilenceClock& silence) {
  Frames frames;
  const std::size_t size = pipeline().feed(byte, frames.data(), with_own_temperature, sample_time);
  if (size == 0) return;
  silence.restart(hal::milliseconds());
  send(frames, size);
  if (!keep_state_if_due()) continue_self_test();
}

// Bytes that form no frame may come at another bit rate than this board's.
void search_bit_rate() {
  constexpr std::uint32_t kFramesBetweenTries = 100;
  static std::uint32_t frames = 0;
  static std::uint32_t discarded = 0;
  if (++frames < kFramesBetweenTries) return;
  frames = 0;
  const std::uint32_t now = pipeline().discarded_bytes();
  if (now != discarded) hal::try_another_speed();
  discarded = now;
}

// Sends one frame if one is due, and returns whether another may be: one per pass of the loop,
// because a frame may take as long as a sample period. With an inaccurate clock late samples cannot
// be detected. Not inline, like the functions below, so that their frames and texts are not on the
// stack at the same time as others.
[[gnu::noinline]] bool break_silence(SilenceClock& silence) {
  if (!silence.due(hal::milliseconds())) return false;
  if (!hal::clock_keeps_time()) return true;
  Frames frames;
  send(frames, pipeline().answer_silence(frames.data()));
  forget_state();
  continue_self_test();
  search_bit_rate();
  return true;
}

constexpr std::uint32_t kMaxFaults = 5;
constexpr std::uint32_t kSafeModePeriodUs = 5000;  // whatever a table says: it may be the reason
constexpr std::uint32_t kGoodRunMs = 60'000;

// After repeated failures in spite of restarts, the board only reports that nothing is valid, until
// it is reset.
[[gnu::noinline]] void answer_without_samples() {
  hal::write_console("SAFE MODE\r\n");
  for (SilenceClock silence(kSafeModePeriodUs, hal::milliseconds());;) {
    hal::wait_for_event();
    break_silence(silence);
    answer_requests();
    hal::kick_watchdog();
  }
}

// The watchdog comes first: without it a start that hangs would leave the board silent for ever.
void start() {
  hal::start_watchdog(hal::kWatchdogStartMs);
  platform::start_board();
  platform::open_lines(sensor_line(), output_line());
  hal::kick_watchdog();
  const hal::ResetReport& reset = hal::reset_report();
  if (reset.counts.faults >= kMaxFaults) answer_without_samples();
  self_test().run_all();
  hal::kick_watchdog();
  announce(platform::describe_board(), reset);
  resume_state(reset.cause);
  start_own_thermometer();
  if constexpr (kKvhCommands) report_start_tests();
  start_loop_watchdog();
}

}  // namespace

void run() {
  start();
  std::array<std::uint8_t, 64> chunk;
  SilenceClock silence(model().parameters.acquisition.sample_period_us, hal::milliseconds());
  bool silent = false;
  for (bool proven = false;;) {
    const std::size_t size = is_loading() ? 0 : hal::read_sensor_stream(chunk.data(), chunk.size());
    if (size == 0 && !silent) hal::wait_for_event();
    for (std::size_t i = 0; i < size; ++i) send_compensated(chunk[i], silence);
    silent = break_silence(silence);
    answer_requests();
    if (hal::milliseconds() - tested_ms >= kIdleMs) continue_self_test();
    advance_own_thermometer();
    if (!proven && hal::milliseconds() >= kGoodRunMs) {
      hal::report_good_run();
      proven = true;
    }
    hal::kick_watchdog();  // the only place in the loop: a kick means a complete pass
  }
}

}  // namespace fog::app
