#include "platform/shared/processor.hpp"

#include <cstdint>

#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "platform/rv32/interrupts.hpp"
#include "platform/shared/restart.hpp"

namespace fog::platform {
namespace {

constexpr std::uint32_t kTimer = 7;  // numbers of mcause, and bits of mie
constexpr std::uint32_t kExternal = 11;

std::uint32_t trap_cause() {
  std::uint32_t cause;
  asm volatile("csrr %0, mcause" : "=r"(cause));
  return cause;
}

}  // namespace

/// Keeps what happened and starts again: the next start tells it. The crash's number is mcause,
/// which is never 0, a misaligned instruction, where instructions may have 16 bits.
extern "C" [[noreturn, gnu::used]] void fog_record_trap(std::uint32_t link_register) {
  hal::CrashRecord crash{};
  crash.exception = trap_cause();
  asm volatile("csrr %0, mepc" : "=r"(crash.program_counter));
  asm volatile("csrr %0, mtval" : "=r"(crash.fault_address));
  crash.link_register = link_register;
  crash.uptime_ms = hal::milliseconds();
  restart(hal::ResetCause::fault, crash);
}

extern "C" [[gnu::interrupt("machine"), gnu::used]] void fog_take_interrupt() {
  const std::uint32_t number = trap_cause() & 0x7FFFFFFFU;
  if (number == kTimer) on_timer_interrupt();
  if (number == kExternal) on_external_interrupt();
}

namespace {

// The one entry of both. Nothing returns from an exception, so it needs nothing of the stack, which
// may be what failed. Aligned, because the low bits of mtvec are its mode.
[[gnu::naked, gnu::aligned(4)]] void trap_entry() {
  asm volatile(
      "csrw mscratch, t0\n"
      "csrr t0, mcause\n"
      "bltz t0, 1f\n"
      "mv a0, ra\n"
      "la sp, fog_stack_top\n"
      "j fog_record_trap\n"
      "1: csrr t0, mscratch\n"
      "j fog_take_interrupt\n");
}

}  // namespace

void prepare_processor() {
  asm volatile("csrw mie, zero");
  asm volatile("csrw mtvec, %0" : : "r"(&trap_entry));
  hal::release_interrupts();
}

void enable_external_interrupts() {
  asm volatile("csrs mie, %0" ::"r"(1U << kExternal) : "memory");
}

}  // namespace fog::platform
