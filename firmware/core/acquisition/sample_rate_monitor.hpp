#pragma once

#include <cstdint>

#include "core/acquisition/sample_time.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Compares the demodulator's sample rate with a clock. The pipeline measures time in samples: at
/// twice the rate it would see half the temperature rate.
class SampleRateMonitor {
 public:
  /// `sample_period_us` >= 1: what the rate should be; one part in `part`, 1 to kMaxPart, of it may
  /// be wrong.
  SampleRateMonitor(std::uint32_t sample_period_us, std::uint32_t part)
      : sample_period_us_(sample_period_us), part_(part) {}
  static constexpr std::int32_t kMaxPart = 1000;

  /// `elapsed`: samples since the last one judged. Returns Status::sample_rate if the rate is off
  /// by more than that over 10 s, or, earlier, by so much that it must be; no flag while no time is
  /// known.
  Status judge(std::uint32_t elapsed, SampleTime now);

 private:
  std::uint32_t sample_period_us_;
  std::uint32_t part_;
  SampleTime since_;           // start of the window
  std::uint32_t samples_ = 0;  // counted in the window
  bool off_ = false;
};

}  // namespace fog
