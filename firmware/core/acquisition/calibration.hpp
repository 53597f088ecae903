#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/rounded_product.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Scale factor of the gyro. rate = counts * multiplier / 2^shift.
struct CalibrationParameters {
  std::int32_t multiplier = 0;  ///< 2^30 <= multiplier < 2^31: 30 significant bits
  int shift = 0;                ///< 0 to kMaxCalibrationShift
};

constexpr int kMaxCalibrationShift = 62;  ///< rounded_product()'s

static_assert(kMaxCalibrationShift < 63, "of 64 bits with a sign");
static_assert(-std::int64_t{INT32_MIN} * INT32_MAX <= INT64_MAX / 2);

/// Demodulator counts as a rate, deg/h: exact product (below 2^62), rounded once, clipped.
inline Rate calibrated_rate(const CalibrationParameters& calibration, std::int32_t counts) {
  return Rate::from_raw(
      saturate<std::int32_t>(rounded_product(counts, calibration.multiplier, calibration.shift)));
}

}  // namespace fog
