#include "platform/shared/processor.hpp"

#include <cstdint>

#include "hal/rate_sink.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/text_line.hpp"

namespace fog::platform {
namespace {

constexpr std::uint32_t kCrashed = 3;  // as the bulk image exits on a board

}  // namespace

/// Says what happened and ends the emulator: what runs here runs for a test.
extern "C" [[noreturn]] void fog_report_trap() {
  std::uint32_t cause;
  std::uint32_t program_counter;
  asm("csrr %0, mcause" : "=r"(cause));
  asm("csrr %0, mepc" : "=r"(program_counter));
  TextLine line;
  line.text("trap: cause ").decimal(cause).text(" at ").hex(program_counter);
  hal::write_console(line.text("\r\n").c_str());
  semihosting::exit(kCrashed);
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
