#pragma once

#include <cstdint>

namespace fog {

/// Tells when a frame without a sample is due: when the last sample is more than two sample periods
/// ago, then once per period. So a user who navigates by the frames keeps getting them and sees at
/// once that they are not valid.
class SilenceClock {
 public:
  /// `sample_period_us` >= 1.
  explicit SilenceClock(std::uint32_t sample_period_us, std::uint32_t now_ms)
      : period_us_(sample_period_us) {
    restart(now_ms);
  }

  /// To be called when a sample has come. The times of sample and frame are whole milliseconds,
  /// rounded down: the difference may be up to 1 ms more than the time that has passed.
  void restart(std::uint32_t now_ms) {
    due_ms_ = now_ms + period_us_ / 500U + 2;  // two periods, rounded up, and this 1 ms
    due_us_ = 0;
  }

  /// Whether a frame is due; it then counts as sent. Times wrap: calls must be less than 24 days
  /// apart.
  bool due(std::uint32_t now_ms) {
    if (static_cast<std::int32_t>(now_ms - due_ms_) < 0) return false;
    put_off();
    return true;
  }

 private:
  void put_off() {
    due_us_ += period_us_ % 1000U;
    due_ms_ += period_us_ / 1000U + due_us_ / 1000U;
    due_us_ %= 1000U;
  }

  std::uint32_t period_us_;
  std::uint32_t due_ms_ = 0;
  std::uint32_t due_us_ = 0;  // fraction of due_ms_, below 1000
};

}  // namespace fog
