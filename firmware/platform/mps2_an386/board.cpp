#include "platform/board.hpp"

#include "hal/clock.hpp"
#include "hal/processor.hpp"
#include "platform/cortex_m/tick.hpp"
#include "platform/mps2_an386/peripherals.hpp"
#include "platform/ports.hpp"
#include "platform/shared/restart.hpp"

// In QEMU the serial lines have no timing.
bool fog::hal::clock_is_accurate() {
  return false;
}

bool fog::hal::clock_keeps_time() {
  return false;
}

void fog::hal::try_another_speed() {}

fog::hal::ProcessorNumber fog::hal::processor_number() {
  return {};
}

namespace fog::platform {

// This machine has no reset flags: only the firmware's own restarts are known.
void start_board() {
  report_reset(hal::ResetCause::unknown);
  start_tick(kClockHz);
  open_console_port();
}

void open_lines(SerialLine sensor, SerialLine output) {
  open_output_port(output);
  open_request_port();
  open_sensor_port(sensor);
}

BoardDescription describe_board() {
  return {"mps2_an386", kClockHz, "fixed oscillator", false, true};
}

void restart_board() {
  restart(hal::ResetCause::self_test);
}

void restart_on_request() {
  restart(hal::ResetCause::software);
}

}  // namespace fog::platform
