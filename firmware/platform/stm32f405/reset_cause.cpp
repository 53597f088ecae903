#include "platform/stm32f405/reset_cause.hpp"

#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {
namespace {

using hal::ResetCause;

// A power-on also sets the brown-out flag, and every reset pulls the reset pin: the first match
// counts.
ResetCause decode(std::uint32_t flags) {
  if ((flags & Rcc::kWatchdogReset) != 0) return ResetCause::watchdog;
  if ((flags & Rcc::kSoftwareReset) != 0) return ResetCause::software;
  if ((flags & Rcc::kPowerOnReset) != 0) return ResetCause::power_on;
  if ((flags & Rcc::kBrownOutReset) != 0) return ResetCause::brown_out;
  if ((flags & Rcc::kPinReset) != 0) return ResetCause::reset_pin;
  return ResetCause::unknown;
}

}  // namespace

ResetCause take_hardware_reset_cause() {
  const ResetCause cause = decode(rcc().status.read());
  rcc().status.set(Rcc::kForgetResetCause);
  return cause;
}

}  // namespace fog::platform
