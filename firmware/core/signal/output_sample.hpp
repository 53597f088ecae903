#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Result of the pipeline for one sensor sample.
struct OutputSample {
  std::uint16_t sequence = 0;  ///< of the sensor sample that caused it
  Rate compensated{};          ///< measured - drift, undelayed
  Rate denoised{};             ///< the same, denoised and late by the denoiser's delay
  Rate drift{};                ///< drift subtracted from the measured rate
  Temperature temperature{};   ///< last good one
  Status status = Status::none;

  bool compensated_valid() const { return !has_any(status, kRateInvalid | Status::rate_refused); }
  bool denoised_valid() const { return !has_any(status, kDenoisedInvalid); }
};

}  // namespace fog
