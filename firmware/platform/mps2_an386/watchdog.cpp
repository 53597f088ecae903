#include "hal/watchdog.hpp"

#include "platform/mps2_an386/peripherals.hpp"

namespace fog::hal {
namespace {

// The emulator's clock goes on while a busy host does not run it: that is not the board's fault.
constexpr std::uint32_t kHostStandsStillMs = 2000;

}  // namespace

// The first expiry raises the NMI, which traps and restarts with a report; if that fails, the
// second expiry resets the processor.
void start_watchdog(std::uint32_t timeout_ms) {
  using platform::CmsdkWatchdog;
  platform::watchdog().load.write(platform::kClockHz / 1000U * (timeout_ms + kHostStandsStillMs));
  platform::watchdog().control.write(CmsdkWatchdog::kInterrupt | CmsdkWatchdog::kReset);
}

void extend_watchdog(std::uint32_t timeout_ms) {
  start_watchdog(timeout_ms);
}

void kick_watchdog() {
  platform::watchdog().interrupt_clear.write(1);
}

}  // namespace fog::hal
