#pragma once

#include <cstdint>

#include "platform/shared/registers.hpp"

namespace fog::platform {

/// A 64-bit count of the machine timer, as a 32-bit processor reaches it.
struct TimerCount {
  Register low;
  Register high;
};

/// Where a machine has its timer ("The RISC-V Instruction Set Manual, Volume II", mtime).
struct MachineTimer {
  const TimerCount* count;
  TimerCount* compare;  ///< an interrupt is pending while count >= compare
  std::uint32_t hz;
};

/// Provided by the machine.
MachineTimer machine_timer();

/// Starts the millisecond tick behind hal/clock.hpp.
void start_tick();

}  // namespace fog::platform
