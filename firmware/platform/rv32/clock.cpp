#include "hal/clock.hpp"

#include "platform/rv32/interrupts.hpp"
#include "platform/rv32/tick.hpp"

namespace fog {
namespace platform {
namespace {

constexpr std::uint32_t kTimerInterrupt = 1U << 7U;  // MTIE of mie

volatile std::uint32_t elapsed_ms = 0;
volatile bool signalled = false;

std::uint64_t read_count(const TimerCount& count) {
  for (;;) {
    const std::uint32_t high = count.high.read();
    const std::uint32_t low = count.low.read();
    if (count.high.read() == high) return (std::uint64_t{high} << 32U) | low;
  }
}

// No value in between is smaller than both the old and the new one, so no interrupt comes early.
void write_compare(TimerCount& compare, std::uint64_t value) {
  compare.high.write(0xFFFFFFFFU);
  compare.low.write(static_cast<std::uint32_t>(value));
  compare.high.write(static_cast<std::uint32_t>(value >> 32U));
}

}  // namespace

void start_tick() {
  const MachineTimer timer = machine_timer();
  write_compare(*timer.compare, read_count(*timer.count) + timer.hz / 1000U);
  asm volatile("csrs mie, %0" ::"r"(kTimerInterrupt) : "memory");
}

void on_timer_interrupt() {
  const MachineTimer timer = machine_timer();
  write_compare(*timer.compare, read_count(*timer.compare) + timer.hz / 1000U);
  elapsed_ms = elapsed_ms + 1;
  signal_event();
}

void signal_event() {
  signalled = true;
}

}  // namespace platform

std::uint32_t hal::milliseconds() {
  return platform::elapsed_ms;
}

// Interrupts are held off between the look at the flag and sleep, which a pending one ends all the
// same. The flag is cleared last, because the caller looks again after this.
void hal::wait_for_event() {
  constexpr std::uint32_t kMachineInterruptEnable = 8;  // MIE of mstatus
  asm volatile("csrc mstatus, %0" ::"r"(kMachineInterruptEnable) : "memory");
  if (!platform::signalled) asm volatile("wfi" ::: "memory");
  asm volatile("csrs mstatus, %0" ::"r"(kMachineInterruptEnable) : "memory");
  platform::signalled = false;
}

}  // namespace fog
