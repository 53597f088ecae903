#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/acquisition/sensor_frame.hpp"

namespace fog {

/// Finds the frames in a byte stream. Self-synchronising: after lost, added or damaged bytes it is
/// back within one good frame, because bytes of a candidate that fails are searched again rather
/// than thrown away; and it accepts no frame whose CRC is wrong.
class StreamParser {
 public:
  /// Takes one byte. Returns true when it completes a good frame, then found in sample().
  bool feed(std::uint8_t byte);

  const SensorSample& sample() const { return sample_; }

  /// Bytes that were part of no good frame, modulo 2^32.
  std::uint32_t discarded_bytes() const { return discarded_; }

 private:
  void drop_to_next_candidate();

  std::array<std::uint8_t, kSensorFrameBytes> window_{};
  std::size_t filled_ = 0;
  std::uint32_t discarded_ = 0;
  SensorSample sample_;
};

}  // namespace fog
