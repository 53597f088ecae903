#pragma once

#include <cstdint>

namespace fog::test {

/// What hal::milliseconds() says to drivers that are compiled for this computer.
std::uint32_t& now_ms();

}  // namespace fog::test
