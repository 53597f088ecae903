#pragma once

#include <cstdint>

#include "core/acquisition/sample_time.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Holds the demodulator's sample rate against a clock. Everything here that lasts is counted in
/// samples: at twice the rate half the temperature rate is seen.
class SampleRateMonitor {
 public:
  /// `sample_period_us` >= 1: what the rate should be.
  explicit SampleRateMonitor(std::uint32_t sample_period_us)
      : sample_period_us_(sample_period_us) {}

  /// `elapsed` samples after the last one judged. Returns sample_rate where the rate is off by more
  /// than 2 % over 10 s, or as far by then that it must be; nothing while no time is known.
  Status judge(std::uint32_t elapsed, SampleTime now);

 private:
  std::uint32_t sample_period_us_;
  SampleTime since_;           // of the samples that are counted
  std::uint32_t samples_ = 0;  // after that
  bool off_ = false;
};

}  // namespace fog
