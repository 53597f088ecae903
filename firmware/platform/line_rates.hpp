#pragma once

#include <cstdint>

namespace fog::platform {

/// Bit rate of the console, 8N1. The model table chooses the other lines.
constexpr std::uint32_t kConsoleBaud = 115200;

}  // namespace fog::platform
