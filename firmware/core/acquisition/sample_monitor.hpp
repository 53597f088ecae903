#pragma once

#include <cstdint>

#include "core/acquisition/rate_monitor.hpp"
#include "core/acquisition/sample_rate_monitor.hpp"
#include "core/acquisition/sample_time.hpp"
#include "core/acquisition/sequence_monitor.hpp"
#include "core/acquisition/stuck_monitor.hpp"
#include "core/acquisition/temperature_monitor.hpp"
#include "core/frames/sensor_frame.hpp"

namespace fog {

/// Limits of what a live gyro and its temperature sensor can send.
struct AcquisitionParameters {
  std::uint32_t sample_period_us = 1;
  Rate range = Rate::highest();     ///< full scale, > 0
  std::uint32_t stuck_samples = 0;  ///< counts in a row within an LSB: a stuck gyro; 0: never
};

/// Judges each sample by itself and by those before it.
class SampleMonitor {
 public:
  struct Verdict : SequenceMonitor::Verdict {
    TemperatureUse temperature = TemperatureUse::none;
    bool temperature_confirmed = false;  ///< there was a reading that can be trusted
  };

  explicit SampleMonitor(const AcquisitionParameters& parameters)
      : sequence_(parameters.sample_period_us),
        sample_rate_(parameters.sample_period_us),
        stuck_(parameters.stuck_samples),
        rate_(parameters.range, parameters.sample_period_us),
        temperature_(parameters.sample_period_us, kConfirmUs) {}

  /// `measured` is the sample's calibrated rate; `now` is when it came.
  Verdict judge(const SensorSample& sample, Rate measured, SampleTime now = {});

 private:
  static constexpr std::uint32_t kConfirmUs = 500'000;  // of a first or far temperature

  SequenceMonitor sequence_;
  SampleRateMonitor sample_rate_;
  StuckMonitor stuck_;
  RateMonitor rate_;
  TemperatureMonitor temperature_;
};

}  // namespace fog
