#pragma once

#include <cstdint>

#include "core/acquisition/sample_time.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Compares the demodulator's sample rate with a clock. The pipeline measures time in samples: at
/// twice the rate it would see half the temperature rate.
class SampleRateMonitor {
 public:
  /// `sample_period_us` >= 1: what the rate should be.
  explicit SampleRateMonitor(std::uint32_t sample_period_us)
      : sample_period_us_(sample_period_us) {}

  /// `elapsed`: samples since the last one judged. Returns Status::sample_rate if the rate is off
  /// by more than 2 % over 10 s, or, earlier, by so much that it must be; no flag while no time is
  /// known.
  Status judge(std::uint32_t elapsed, SampleTime now);

 private:
  std::uint32_t sample_period_us_;
  SampleTime since_;           // start of the window
  std::uint32_t samples_ = 0;  // counted in the window
  bool off_ = false;
};

}  // namespace fog
