#include "platform/shared/processor.hpp"

#include <cstdint>

#include "hal/rate_sink.hpp"
#include "platform/board.hpp"
#include "platform/shared/linker_symbols.hpp"
#include "platform/text_line.hpp"

namespace fog::platform {

/// Says what happened and starts again, as on the Cortex-M.
extern "C" [[noreturn]] void fog_report_trap() {
  std::uint32_t cause;
  std::uint32_t program_counter;
  asm("csrr %0, mcause" : "=r"(cause));
  asm("csrr %0, mepc" : "=r"(program_counter));
  TextLine line;
  line.text("trap: cause ").decimal(cause).text(" at ").hex(program_counter);
  hal::write_console(line.text(", restarting\r\n").c_str());
  restart_board();
}

namespace {

// Nothing returns from here, so nothing on the stack is needed any more. Aligned, because the low
// bits of mtvec are its mode.
[[gnu::naked, gnu::aligned(4)]] void trap_entry() {
  asm volatile(
      "la sp, fog_stack_top\n"
      "j fog_report_trap\n");
}

}  // namespace

void prepare_processor() {
  asm volatile("csrw mtvec, %0" : : "r"(&trap_entry));
}

}  // namespace fog::platform
