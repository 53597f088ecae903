#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {

using Handler = void (*)();

/// Entry points of start-up and fault handling; C names for linker script and assembly.
extern "C" {
[[noreturn]] void fog_reset_handler();
void fog_trap_handler();
void fog_tick_handler();
}

constexpr std::size_t kReset = 1;
constexpr std::size_t kNmi = 2;
constexpr std::size_t kSysTick = 15;
constexpr std::size_t kExceptions = 16;

/// Table read by the processor at reset and at every exception (ARM DDI 0403, B1.5.3).
template <std::size_t kInterrupts>
struct VectorTable {
  std::uint32_t* initial_stack;
  std::array<Handler, kExceptions - 1> exceptions;
  std::array<Handler, kInterrupts> interrupts;
};

struct InterruptHandler {
  std::size_t number;
  Handler handler;
};

/// Table of a part with `kInterrupts` lines. Lines not listed in `handled` trap: an interrupt that
/// was not enabled is a fault.
template <std::size_t kInterrupts, std::size_t kHandled>
constexpr VectorTable<kInterrupts> make_vector_table(const InterruptHandler (&handled)[kHandled]) {
  VectorTable<kInterrupts> table{fog_stack_top, {}, {}};
  for (Handler& entry : table.exceptions) entry = fog_trap_handler;
  for (Handler& entry : table.interrupts) entry = fog_trap_handler;
  table.exceptions[kReset - 1] = fog_reset_handler;
  table.exceptions[kSysTick - 1] = fog_tick_handler;
  for (const InterruptHandler& entry : handled) table.interrupts[entry.number] = entry.handler;
  return table;
}

}  // namespace fog::platform
