#include "core/acquisition/stream_parser.hpp"

namespace fog {

bool StreamParser::feed(std::uint8_t byte) {
  window_[filled_++] = byte;
  if (filled_ <= 2) {
    const std::uint8_t expected = filled_ == 1 ? kSensorSync0 : kSensorSync1;
    if (byte != expected) drop_to_next_candidate();
    return false;
  }
  if (filled_ < kSensorFrameBytes) return false;
  if (decode_sensor_frame(window_.data(), sample_)) {
    filled_ = 0;
    return true;
  }
  drop_to_next_candidate();
  return false;
}

// Drops the first byte and all that follow it up to the next place where a frame could start. What
// is left is shorter than a frame, so nothing in it can be complete yet: one call per byte is
// enough.
void StreamParser::drop_to_next_candidate() {
  std::size_t start = 1;
  while (start < filled_) {
    const bool sync0 = window_[start] == kSensorSync0;
    const bool sync1 = start + 1 == filled_ || window_[start + 1] == kSensorSync1;
    if (sync0 && sync1) break;
    ++start;
  }
  for (std::size_t i = start; i < filled_; ++i) window_[i - start] = window_[i];
  discarded_ += static_cast<std::uint32_t>(start);
  filled_ -= start;
}

}  // namespace fog
