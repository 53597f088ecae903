#include "platform/board.hpp"

#include "hal/reset_report.hpp"

#include "platform/rv32_virt/peripherals.hpp"

namespace fog {

const hal::ResetReport& hal::reset_report() {
  static constexpr ResetReport kNothingKnown{};
  return kNothingKnown;
}

namespace platform {

// Nothing to start: the bulk image uses no serial lines, tick or watchdog.
void start_board() {}

BoardDescription describe_board() {
  return {"rv32_virt", 0, "the emulator", false, true};
}

void restart_board() {
  test_device().command.write(TestDevice::kRestart);
  for (;;) {
  }
}

}  // namespace platform
}  // namespace fog
