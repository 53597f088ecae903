#include "platform/cortex_m/event.hpp"

#include "hal/clock.hpp"

namespace fog {
namespace platform {
namespace {

volatile bool signalled = false;

}  // namespace

void signal_event() {
  signalled = true;
}

}  // namespace platform

// WFE alone would do this, but QEMU does not sleep on WFE and starves its own serial ports. WFI
// alone would miss an interrupt between the caller's last check and this call. So interrupts are
// disabled until the processor sleeps (they still wake it), and the flag shows those that came
// before. It is cleared last, because the caller checks again afterwards.
void hal::wait_for_event() {
  asm volatile("cpsid i" ::: "memory");
  if (!platform::signalled) asm volatile("wfi" ::: "memory");
  asm volatile("cpsie i\n isb" ::: "memory");
  platform::signalled = false;
}

}  // namespace fog
