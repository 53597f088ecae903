#include "platform/board.hpp"

#include "platform/rv32_virt/peripherals.hpp"

namespace fog::platform {

// Nothing to start: the bulk image has no lines, no tick and no watchdog.
void start_board() {}

BoardDescription describe_board() {
  return {"rv32_virt", 0, "the emulator", "unknown"};
}

void restart_board() {
  test_device().command.write(TestDevice::kRestart);
  for (;;) {
  }
}

}  // namespace fog::platform
