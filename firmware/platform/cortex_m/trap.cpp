#include <cstdint>

#include "hal/rate_sink.hpp"
#include "platform/cortex_m/restart.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/cortex_m/vector_table.hpp"
#include "platform/text_line.hpp"

namespace fog::platform {
namespace {

/// What the processor pushed when it took the exception (ARM DDI 0403, B1.5.6).
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

}  // namespace

/// Says what happened and starts again: a gyro that restarts visibly is worth more than one that
/// hangs. `frame` is null where the stack was unusable.
extern "C" [[noreturn]] void fog_report_trap(const ExceptionFrame* frame) {
  TextLine line;
  line.text("trap: exception ").decimal(active_exception());
  if (frame != nullptr) {
    line.text(" at ").hex(frame->program_counter);
  } else {
    line.text(", stack exhausted");
  }
  line.text(", fault status ").hex(system_control_block().configurable_fault_status.read());
  hal::write_console(line.text(", restarting\r\n").c_str());
  restart(RestartReason::kFault);
}

// A stack overflow ends below the start of the memory, where no handler could push anything. So the
// stack pointer is checked before the first push, and rewound where the report would not fit:
// nothing returns from here, so nothing on the stack is needed any more but the frame.
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
      "2: b fog_report_trap\n");
}

}  // namespace fog::platform
