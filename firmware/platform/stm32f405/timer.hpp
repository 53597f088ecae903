#pragma once

#include <cstdint>

namespace fog::platform {

/// TIM2, 32 bits, free-running. On the chip it counts cycles of the timer clock; in QEMU with
/// `-icount shift=0,sleep=off` one tick is one instruction.
void start_timer();
std::uint32_t timer_ticks();

}  // namespace fog::platform
