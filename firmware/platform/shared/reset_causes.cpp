#include "hal/reset_report.hpp"

namespace fog::hal {

const char* describe(ResetCause cause) {
  switch (cause) {
    case ResetCause::unknown:
      break;
    case ResetCause::power_on:
      return "power-on";
    case ResetCause::brown_out:
      return "brown-out";
    case ResetCause::reset_pin:
      return "reset pin";
    case ResetCause::watchdog:
      return "watchdog";
    case ResetCause::software:
      return "software";
    case ResetCause::clock_failure:
      return "clock failure";
    case ResetCause::fault:
      return "fault";
    case ResetCause::self_test:
      return "self-test";
  }
  return "unknown";
}

}  // namespace fog::hal
