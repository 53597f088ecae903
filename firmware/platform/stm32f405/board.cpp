#include "platform/board.hpp"

#include "hal/clock.hpp"
#include "platform/cortex_m/tick.hpp"
#include "platform/ports.hpp"
#include "platform/shared/restart.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/peripherals.hpp"
#include "platform/stm32f405/reset_cause.hpp"

bool fog::hal::clock_is_accurate() {
  return !platform::clock_tree().is_fallback;
}

// Even the internal oscillator locks the PLL; if it does not lock, this is an emulator or a
// defective part.
bool fog::hal::clock_keeps_time() {
  return platform::clock_tree().has_full_speed;
}

namespace fog::platform {
namespace {

// Limit, because a crystal that fails now and then would cause an endless series of restarts.
constexpr std::uint32_t kMaxClockFailures = 3;

}  // namespace

void start_board() {
  report_reset(take_hardware_reset_cause());
  start_clock_tree(hal::reset_report().counts.clock_failures < kMaxClockFailures);
  start_tick(clock_tree().core_hz);
  open_console_port();
}

void open_lines(SerialLine sensor, SerialLine output) {
  open_output_port(output);
  open_request_port();
  open_sensor_port(sensor);
}

// The brown-out level is an option byte, set when the part is flashed (firmware/README.md).
BoardDescription describe_board() {
  const bool brown_out_reset_on =
      (flash().options.read() & Flash::kBrownOutLevel) != Flash::kBrownOutOff;
  return {FOG_BOARD_NAME, clock_tree().core_hz, clock_tree().source, clock_tree().is_fallback,
          brown_out_reset_on};
}

void restart_board() {
  restart(hal::ResetCause::self_test);
}

void restart_on_request() {
  restart(hal::ResetCause::software);
}

}  // namespace fog::platform
