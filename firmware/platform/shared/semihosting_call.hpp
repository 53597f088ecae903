#pragma once

#include <cstdint>

namespace fog::platform::semihosting {

/// Passes `operation` with its argument block to the emulator or debugger, by the instruction that
/// the processor has for it. Returns the result.
std::int32_t semihosting_call(std::uint32_t operation, const std::uint32_t* arguments);

}  // namespace fog::platform::semihosting
