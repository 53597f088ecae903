#pragma once

#include <cstddef>
#include <cstdint>

#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"

namespace fog {

/// Largest number of bytes sent per sensor sample: both frames.
constexpr std::size_t kMaxOutputBytes = kKvhFrameBytes + kCompactFrameBytes;

/// Bit rate of the output line, 8N1.
constexpr std::uint32_t kOutputBaud = 921'600;

/// Time that `bytes` (at most kMaxOutputBytes) take on the output line, us, rounded up.
constexpr std::uint32_t output_line_us(std::size_t bytes) {
  constexpr std::uint32_t kBitsPerByte = 10;
  constexpr std::uint32_t kUsPerS = 1'000'000;
  return (static_cast<std::uint32_t>(bytes) * kBitsPerByte * kUsPerS + kOutputBaud - 1) /
         kOutputBaud;
}

}  // namespace fog
