#include "hal/service_strap.hpp"

#include "platform/mps2_an386/peripherals.hpp"

// The emulator gives this machine no pin that can be set, but memory behind that of the firmware:
// 0 there, as it is at power-on, is an open strap.
bool fog::hal::service_strap_closed() {
  return platform::peripheral_at<platform::Register>(0x20020000U).read() != 0;
}
