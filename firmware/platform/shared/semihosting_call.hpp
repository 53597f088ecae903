#pragma once

#include <cstdint>

namespace fog::platform::semihosting {

/// Hands `operation` with its block of arguments to the emulator or debugger: the instruction that
/// each processor has for it. Returns what comes back.
std::int32_t semihosting_call(std::uint32_t operation, const std::uint32_t* arguments);

}  // namespace fog::platform::semihosting
