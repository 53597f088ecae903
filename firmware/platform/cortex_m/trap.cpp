#include <cstdint>

#include "hal/clock.hpp"
#include "platform/cortex_m/nmi.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/cortex_m/vector_table.hpp"
#include "platform/shared/restart.hpp"

namespace fog::platform {
namespace {

/// Registers pushed by the processor on an exception (ARM DDI 0403, B1.5.6).
struct ExceptionFrame {
  std::uint32_t r0, r1, r2, r3, r12;
  std::uint32_t return_address;
  std::uint32_t program_counter;
  std::uint32_t program_status;
};

std::uint32_t active_exception() {
  std::uint32_t number;
  asm("mrs %0, ipsr" : "=r"(number));
  return number;
}

std::uint32_t fault_address(const SystemControlBlock& control, std::uint32_t status) {
  if ((status & SystemControlBlock::kMemoryAddressValid) != 0) {
    return control.memory_fault_address.read();
  }
  return (status & SystemControlBlock::kBusAddressValid) != 0 ? control.bus_fault_address.read()
                                                              : 0;
}

}  // namespace

/// Records the exception and restarts the board. The next start reports it; nothing is sent from
/// here, because that takes time and working ports. `frame` is null if the stack was unusable.
extern "C" [[noreturn]] void fog_record_trap(const ExceptionFrame* frame) {
  const SystemControlBlock& control = system_control_block();
  hal::CrashRecord crash{};
  crash.exception = active_exception();
  crash.fault_status = control.configurable_fault_status.read();
  crash.fault_address = fault_address(control, crash.fault_status);
  crash.uptime_ms = hal::milliseconds();
  if (frame != nullptr) {
    crash.program_counter = frame->program_counter;
    crash.link_register = frame->return_address;
  }
  restart(crash.exception == kNmi ? kNmiCause : hal::ResetCause::fault, crash);
}

// A stack overflow ends in the guard below the stack, where a handler cannot push anything. So the
// stack pointer is checked before the first push and reset if the record would not fit. Only the
// frame is needed of the old stack, because the handler never returns.
[[gnu::naked]] void fog_trap_handler() {
  asm volatile(
      "mrs r0, msp\n"
      "ldr r1, =fog_stack_bottom + 256\n"
      "ldr r2, =fog_stack_top - 32\n"
      "cmp r0, r1\n"
      "blo 1f\n"
      "cmp r0, r2\n"
      "bls 2f\n"
      "1: add r2, #32\n"
      "mov sp, r2\n"
      "movs r0, #0\n"
      "2: b fog_record_trap\n");
}

}  // namespace fog::platform
