#include "core/frames/stream_parser.hpp"

namespace fog {

static_assert(2 * kExtensionFrameBytes > kSensorFrameBytes);

// The window starts with a candidate or is empty. When a candidate fails, only its first byte is
// dropped. The 15 bytes left may contain one whole record, but not two, so a byte completes at most
// one frame.
StreamParser::Found StreamParser::feed(std::uint8_t byte) {
  window_[filled_++] = byte;
  if (filled_ > 2 && filled_ < candidate_bytes())
    return Found::nothing;  // candidate still incomplete
  for (;;) {
    while (filled_ > 0 && !starts_like_a_frame()) {
      drop(1);
      ++discarded_;
    }
    if (filled_ < 2 || filled_ < candidate_bytes()) return Found::nothing;
    const std::size_t size = candidate_bytes();
    const Found found = decode();
    if (found != Found::nothing) {
      drop(size);
      return found;
    }
    drop(1);
    ++discarded_;
  }
}

bool StreamParser::starts_like_a_frame() const {
  if (window_[0] != kSensorSync0) return false;
  return filled_ == 1 || window_[1] == kSensorSync1 || window_[1] == kExtensionSync1;
}

std::size_t StreamParser::candidate_bytes() const {
  return window_[1] == kSensorSync1 ? kSensorFrameBytes : kExtensionFrameBytes;
}

StreamParser::Found StreamParser::decode() {
  if (decode_sensor_frame(window_.data(), sample_)) return Found::sample;
  if (decode_extension_frame(window_.data(), extension_)) return Found::extension;
  return Found::nothing;
}

void StreamParser::drop(std::size_t count) {
  filled_ -= count;
  for (std::size_t i = 0; i < filled_; ++i) window_[i] = window_[i + count];
}

}  // namespace fog
