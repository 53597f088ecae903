#pragma once

#include <cstdint>

namespace fog::platform {

/// Bit rates of the three serial lines, all 8N1.
constexpr std::uint32_t kSensorBaud = 921600;
constexpr std::uint32_t kOutputBaud = 921600;
constexpr std::uint32_t kConsoleBaud = 115200;

}  // namespace fog::platform
