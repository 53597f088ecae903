#pragma once

#include <cstdint>

#include "core/frames/output_bytes.hpp"

namespace fog::platform {

/// Bit rates of the three serial lines, all 8N1.
constexpr std::uint32_t kSensorBaud = 921600;
using fog::kOutputBaud;
constexpr std::uint32_t kConsoleBaud = 115200;

}  // namespace fog::platform
