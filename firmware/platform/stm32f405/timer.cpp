#include "platform/stm32f405/timer.hpp"

#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {

void start_timer() {
  enable_clock(rcc().apb1_enable, Rcc::kTimer2);
  timer2().reload.write(0xFFFFFFFFU);
  timer2().control1.write(Timer::kEnable);
}

std::uint32_t timer_ticks() {
  return timer2().count.read();
}

}  // namespace fog::platform
