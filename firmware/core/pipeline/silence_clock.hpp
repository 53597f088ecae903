#pragma once

#include <cstdint>

namespace fog {

/// Says when a frame is due that no sample has caused: two sample periods after the last sample,
/// then one a period, so that whoever flies by the frames goes on getting them and sees at once
/// that they are not valid.
class SilenceClock {
 public:
  /// `sample_period_us` >= 1.
  explicit SilenceClock(std::uint32_t sample_period_us, std::uint32_t now_ms)
      : period_us_(sample_period_us) {
    restart(now_ms);
  }

  /// A sample has come.
  void restart(std::uint32_t now_ms) {
    due_ms_ = now_ms;
    due_us_ = 0;
    put_off();
    put_off();
  }

  /// Whether a frame is due, which is then taken to be sent. Wants to be asked again until it says
  /// no. Times wrap: within 24 days of the one before.
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
  std::uint32_t due_us_ = 0;  // behind due_ms_, below 1000
};

}  // namespace fog
