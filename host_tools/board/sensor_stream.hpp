#pragma once

#include <cstdint>
#include <functional>

#include "core/acquisition/sample_time.hpp"
#include "core/signal/inputs.hpp"
#include "core/signal/span.hpp"
#include "recording/recording.hpp"

namespace fogcomp::board {

/// Receives bytes of a sensor stream and the arrival time of their sample, if known.
using TimedByteSink = std::function<void(fog::Span<const std::uint8_t>, fog::SampleTime)>;
using ByteSink = std::function<void(fog::Span<const std::uint8_t>)>;

/// The sensor stream that a board would have received for a recording: counts by the scale factor,
/// one frame per row, sequence numbers with the gaps of the recording, and before each frame an
/// extension record for every input in `extension`, whose columns the recording must have.
/// Delivered row by row with times; reports progress to `watch`.
void make_sensor_stream(const recording::Recording& recording, double scale_factor,
                        fog::InputMask extension, const TimedByteSink& sink,
                        const recording::ReadWatch& watch = {});

}  // namespace fogcomp::board
