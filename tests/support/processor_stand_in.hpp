#pragma once

#include <cstdint>

namespace fog::test {

/// Value of hal::milliseconds() for drivers compiled for this computer.
std::uint32_t& now_ms();

/// Last arguments of platform::allow_writes().
bool& writes_allowed();

}  // namespace fog::test
