#pragma once

#include <cstddef>

#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"

namespace fog {

/// Most bytes that one sensor sample causes to be sent: both frames.
constexpr std::size_t kMaxOutputBytes = kKvhFrameBytes + kCompactFrameBytes;

}  // namespace fog
