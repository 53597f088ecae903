#pragma once

#include <cstdint>
#include <functional>

#include "core/acquisition/sample_time.hpp"
#include "core/signal/inputs.hpp"
#include "core/signal/span.hpp"
#include "recording/recording.hpp"

namespace fogcomp::board {

/// Bytes of a sensor stream, and when the sample that they hold came, if that is known.
using TimedByteSink = std::function<void(fog::Span<const std::uint8_t>, fog::SampleTime)>;
using ByteSink = std::function<void(fog::Span<const std::uint8_t>)>;

/// The sensor stream in which the board would have seen a recording: counts by the scale factor,
/// one frame per row, sequence numbers that leave out what a gap left out, and before each an
/// extension record for every input in `extension`, whose columns the recording must have. Handed
/// over row by row, with the time of each; `watch` is told how much is done.
void make_sensor_stream(const recording::Recording& recording, double scale_factor,
                        fog::InputMask extension, const TimedByteSink& sink,
                        const recording::ReadWatch& watch = {});

}  // namespace fogcomp::board
