#include "platform/shared/processor.hpp"

#include <cstdint>

#include "hal/rate_sink.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/text_line.hpp"

namespace fog::platform {
namespace {

constexpr std::uint32_t kCrashed = 3;  // exit code of the bulk image, as on a board

}  // namespace

/// Reports the exception and ends the emulator.
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

// Never returns, so the old stack is not needed. Aligned, because the low bits of mtvec are its
// mode.
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
