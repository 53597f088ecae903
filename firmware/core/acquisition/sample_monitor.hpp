#pragma once

#include <cstdint>

#include "core/acquisition/sensor_frame.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Limits of what a live gyro and its temperature sensor can send.
struct AcquisitionParameters {
  std::uint32_t stuck_samples = 0;  ///< equal counts in a row that mean a stuck gyro; 0: never
};

/// A coil between -70 and +130 degC; anything else is a broken sensor.
constexpr Temperature kLeastTemperature = from_integer<Temperature>(-70);
constexpr Temperature kMostTemperature = from_integer<Temperature>(130);
constexpr bool is_possible(Temperature temperature) {
  return temperature >= kLeastTemperature && temperature <= kMostTemperature;
}

/// Judges each sample by itself and by those before it.
class SampleMonitor {
 public:
  struct Verdict {
    Status status = Status::none;
    std::uint32_t missing = 0;  ///< samples lost just before this one
  };

  explicit SampleMonitor(const AcquisitionParameters& parameters) : parameters_(parameters) {}

  Verdict judge(const SensorSample& sample);

 private:
  AcquisitionParameters parameters_;
  bool first_ = true;
  std::uint16_t last_sequence_ = 0;
  std::int32_t last_counts_ = 0;
  std::uint32_t equal_counts_ = 0;
};

}  // namespace fog
