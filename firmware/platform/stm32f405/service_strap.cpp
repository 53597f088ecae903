#include "hal/service_strap.hpp"

#include "platform/stm32f405/pin_modes.hpp"
#include "wiring.hpp"

// 35 us of reads, at least: a pin that is open is pulled up within some. One high and it is open.
bool fog::hal::service_strap_closed() {
  constexpr int kReads = 1000;
  platform::connect_input(platform::kServiceStrap);
  for (int i = 0; i < kReads; ++i) {
    if (platform::is_high(platform::kServiceStrap)) return false;
  }
  return true;
}
