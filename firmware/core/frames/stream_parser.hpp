#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/frames/extension_frame.hpp"
#include "core/frames/sensor_frame.hpp"

namespace fog {

/// Finds the frames in a byte stream. Self-synchronising: after lost, added or damaged bytes it is
/// back within one good frame, because the bytes of a failed candidate are searched again. It
/// accepts no frame whose CRC is wrong.
class StreamParser {
 public:
  enum class Found : std::uint8_t { nothing, sample, extension };

  /// Takes one byte and returns what it completes: a sample, available in sample(), or an extension
  /// record, available in extension().
  Found feed(std::uint8_t byte);

  const SensorSample& sample() const { return sample_; }
  const ExtensionRecord& extension() const { return extension_; }

  /// Bytes that belonged to no good frame, modulo 2^32.
  std::uint32_t discarded_bytes() const { return discarded_; }

 private:
  bool starts_like_a_frame() const;
  std::size_t candidate_bytes() const;
  Found decode();
  void drop(std::size_t count);

  std::array<std::uint8_t, kSensorFrameBytes> window_{};
  std::size_t filled_ = 0;
  std::uint32_t discarded_ = 0;
  SensorSample sample_;
  ExtensionRecord extension_;
};

}  // namespace fog
