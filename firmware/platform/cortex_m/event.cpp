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

// WFE would do all of this in one instruction, but QEMU runs on at WFE, at full load, and starves
// its own serial ports. WFI alone would sleep through an interrupt that came between the caller's
// last look and here; so interrupts are held off until asleep, which they end all the same, and the
// flag tells of those that came before. It is cleared last, because the caller looks again after
// this.
void hal::wait_for_event() {
  asm volatile("cpsid i" ::: "memory");
  if (!platform::signalled) asm volatile("wfi" ::: "memory");
  asm volatile("cpsie i\n isb" ::: "memory");
  platform::signalled = false;
}

}  // namespace fog
