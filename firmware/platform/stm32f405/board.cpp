#include "platform/board.hpp"

#include "platform/cortex_m/restart.hpp"
#include "platform/cortex_m/tick.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {
namespace {

const char* reset_cause = "unknown";

// A power-on also sets the brown-out flag, and every reset pulls the reset pin: first match counts.
const char* hardware_reset_cause() {
  const Register& status = rcc().status;
  if (status.any(Rcc::kWatchdogReset)) return "watchdog";
  if (status.any(Rcc::kSoftwareReset)) return "software";
  if (status.any(Rcc::kPowerOnReset)) return "power-on";
  if (status.any(Rcc::kBrownOutReset)) return "brown-out";
  if (status.any(Rcc::kPinReset)) return "reset pin";
  return "unknown";
}

const char* take_reset_cause() {
  const RestartReason reason = take_restart_reason();
  const char* cause = hardware_reset_cause();
  rcc().status.set(Rcc::kForgetResetCause);
  if (reason == RestartReason::kFault) return "fault";
  if (reason == RestartReason::kRequest) return "request";
  return cause;
}

}  // namespace

void start_board() {
  reset_cause = take_reset_cause();
  start_clock_tree();
  start_tick(clock_tree().core_hz);
  open_console_port();
  open_output_port();
  open_request_port();
  open_sensor_port();
}

BoardDescription describe_board() {
  return {"stm32f405", clock_tree().core_hz, clock_tree().source, reset_cause};
}

void restart_board() {
  restart(RestartReason::kRequest);
}

}  // namespace fog::platform
