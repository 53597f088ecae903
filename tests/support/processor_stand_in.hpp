#pragma once

#include <cstdint>

namespace fog::test {

/// What hal::milliseconds() says to drivers that are compiled for this computer.
std::uint32_t& now_ms();

/// What platform::allow_writes() was told last.
bool& writes_allowed();

}  // namespace fog::test
