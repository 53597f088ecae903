#pragma once

#include <cstdint>
#include <functional>

#include "core/signal/span.hpp"
#include "dataset/recording.hpp"

namespace fogcomp {

using ByteSink = std::function<void(fog::Span<const std::uint8_t>)>;

/// The sensor stream in which the board would have seen a recording: counts by the scale factor,
/// one frame per row, sequence numbers that leave out what a gap left out. Handed over in pieces.
void make_sensor_stream(const Recording& recording, double scale_factor, const ByteSink& sink);

}  // namespace fogcomp
