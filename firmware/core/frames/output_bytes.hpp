#pragma once

#include <cstddef>

#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"

namespace fog {

/// Largest number of bytes sent per sensor sample: both frames.
constexpr std::size_t kMaxOutputBytes = kKvhFrameBytes + kCompactFrameBytes;

}  // namespace fog
