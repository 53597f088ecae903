#include "hal/service_strap.hpp"

#include "platform/stm32f405/pin_modes.hpp"
#include "wiring.hpp"

// Reads for at least 35 us, because an open pin takes some time to be pulled up. One high level
// means open.
bool fog::hal::service_strap_closed() {
  constexpr int kReads = 1000;
  platform::connect_input(platform::kServiceStrap);
  for (int i = 0; i < kReads; ++i) {
    if (platform::is_high(platform::kServiceStrap)) return false;
  }
  return true;
}
