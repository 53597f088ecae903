#pragma once

#include <optional>

#include "recording/recording.hpp"

namespace fogcomp::noise {

/// Standard deviation, in deg/h, of the noise in a mean over `average_s`, which no drift model can
/// remove, from the recording alone: its Hadamard deviation at that time,
///   sqrt(mean (y[i+2] - 2 y[i+1] + y[i])^2 / 6),   y = neighbouring means,
/// with means starting every eighth of their length, without differences beyond 3.5 sigma (spikes,
/// steps; sigma initially from the median).
///
/// If the input rate changes, the part explained by scale factor errors is subtracted from the
/// differences (input_rate_columns()): constant, with temperature, of a part that is warmed late,
/// nonlinear, asymmetric, of a late record.
///
/// White noise: exact, with an error of about 0.6/sqrt(means). Ramps and drifts with little
/// curvature over a mean do not contribute. Flicker noise of coefficient B contributes 0.60 B, the
/// part that changes from mean to mean. Its slower part, like a random walk, looks like drift and
/// is left to the models.
///
/// Masked times are left out, and the means in which they would be. With fewer than 30 means,
/// shorter ones are used, assuming white noise in between. Nothing for fewer than 3 rows without a
/// gap.
std::optional<double> noise_floor_dph(const recording::Recording& recording, double average_s);

/// White noise density of the rate, deg/h in 1 s (angle random walk in deg/sqrt(h), times 60), from
/// the median absolute second difference of neighbouring samples, which neither drift nor outliers
/// affect. 0 for fewer than four rows.
double white_noise_dph_rthz(const recording::Recording& recording);

}  // namespace fogcomp::noise
