#pragma once

#include <cstdint>

namespace fog::platform {

/// For measurements only. Counts clock ticks of a free-running timer; in QEMU's netduinoplus2 with
/// `-icount shift=0` one tick is one instruction. Instructions are not cycles.
void start_instruction_counter();

std::uint32_t instruction_count();

}  // namespace fog::platform
