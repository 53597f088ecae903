#include "platform/instruction_counter.hpp"

#include "platform/stm32f405/peripherals.hpp"

// TIM2, 32 bits, because QEMU does not emulate the cycle counter of the debug unit.
namespace fog::platform {

void start_instruction_counter() {
  enable_clock(apb_enable(Bus::kApb1), Rcc::kTimer2);
  timer2().prescaler.write(0);
  timer2().auto_reload.write(0xFFFFFFFFU);
  timer2().event.write(Timer::kUpdate);
  timer2().control1.write(Timer::kEnable);
}

std::uint32_t instruction_count() {
  return timer2().count.read();
}

}  // namespace fog::platform
