#include "platform/board.hpp"

#include "platform/cortex_m/restart.hpp"
#include "platform/cortex_m/tick.hpp"
#include "platform/mps2_an386/peripherals.hpp"
#include "platform/ports.hpp"

namespace fog::platform {
namespace {

const char* reset_cause = "unknown";

// This machine keeps no record of resets: only the firmware's own restarts are known.
const char* take_reset_cause() {
  switch (take_restart_reason()) {
    case RestartReason::kFault:
      return "fault";
    case RestartReason::kRequest:
      return "request";
    case RestartReason::kNone:
      break;
  }
  return "unknown";
}

}  // namespace

void start_board() {
  reset_cause = take_reset_cause();
  start_tick(kClockHz);
  open_console_port();
  open_output_port();
  open_request_port();
  open_sensor_port();
}

BoardDescription describe_board() {
  return {"mps2_an386", kClockHz, "fixed oscillator", reset_cause};
}

void restart_board() {
  restart(RestartReason::kRequest);
}

}  // namespace fog::platform
