#include "hal/service_strap.hpp"

#include "platform/mps2_an386/peripherals.hpp"

// The emulator has no pin that can be set for this machine. A word of memory above the firmware's
// stands for the strap: 0, its value at power-on, is open.
bool fog::hal::service_strap_closed() {
  return platform::peripheral_at<platform::Register>(0x20020000U).read() != 0;
}
