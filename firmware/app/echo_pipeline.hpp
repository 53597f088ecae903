#pragma once

#include <cstddef>
#include <cstdint>

#include "core/acquisition/sensor_frame.hpp"
#include "core/acquisition/stream_parser.hpp"

namespace fog {

constexpr std::size_t kMostOutputBytes = kSensorFrameBytes;

/// Sends every good sensor frame back unchanged: the shortest path through an image, for bringing
/// up a board and its lines before any model exists.
class EchoPipeline {
 public:
  /// Takes one byte; returns how many bytes of output (0, or up to kMostOutputBytes) it completed.
  std::size_t feed(std::uint8_t byte, std::uint8_t* out) {
    if (!parser_.feed(byte)) return 0;
    for (const std::uint8_t frame_byte : encode_sensor_frame(parser_.sample())) {
      *out++ = frame_byte;
    }
    return kSensorFrameBytes;
  }

 private:
  StreamParser parser_;
};

}  // namespace fog
