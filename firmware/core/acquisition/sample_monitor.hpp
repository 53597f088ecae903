#pragma once

#include <cstdint>

#include "core/acquisition/rate_monitor.hpp"
#include "core/acquisition/reading_monitor.hpp"
#include "core/acquisition/sample_rate_monitor.hpp"
#include "core/acquisition/sample_time.hpp"
#include "core/acquisition/sequence_monitor.hpp"
#include "core/acquisition/stuck_monitor.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// Time for which the first readings of an input, or those far from the last good one, have to
/// agree.
constexpr std::uint32_t kConfirmUs = 500'000;

/// Limits of what a working gyro and its temperature sensor can send.
struct AcquisitionParameters {
  std::uint32_t sample_period_us = 5000;  ///< used without a model, too, when samples stop
  std::uint32_t sample_rate_part = 1;     ///< one part in this many of the sample rate may be wrong
  RateLimits rate;
  StuckLimits stuck;
  Span<const std::int32_t> input_limits;  ///< of the extension inputs that the model needs
};

/// Judges each sample by its values and by its predecessors.
class SampleMonitor {
 public:
  struct Verdict : SequenceMonitor::Verdict {
    ReadingUse temperature = ReadingUse::none;
    bool temperature_confirmed = false;  ///< a reading has been confirmed
  };

  explicit SampleMonitor(const AcquisitionParameters& parameters)
      : sequence_(parameters.sample_period_us),
        sample_rate_(parameters.sample_period_us, parameters.sample_rate_part),
        stuck_(parameters.stuck),
        rate_(parameters.rate, parameters.sample_period_us),
        temperature_(parameters.sample_period_us, kConfirmUs) {}

  /// `measured`: calibrated rate of the sample; `now`: its time of arrival.
  Verdict judge(const SensorSample& sample, Rate measured, SampleTime now = {});

  /// State kept over a restart: the sequence numbers, and `temperature` as a confirmed reading.
  void carry(StateCarrier& state, Temperature temperature) {
    sequence_.carry(state);
    if (state.restores()) temperature_.resume(temperature);
  }
  void set_newest_time(SampleTime then) { sequence_.set_newest_time(then); }

 private:
  SequenceMonitor sequence_;
  SampleRateMonitor sample_rate_;
  StuckMonitor stuck_;
  RateMonitor rate_;
  TemperatureMonitor temperature_;
};

}  // namespace fog
