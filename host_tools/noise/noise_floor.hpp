#pragma once

#include <optional>

#include "recording/recording.hpp"

namespace fogcomp::noise {

/// Standard deviation, in deg/h, of what no drift model can remove from a mean over `average_s`,
/// from the recording alone: its Hadamard deviation at that time,
///   sqrt(mean (y[i+2] - 2 y[i+1] + y[i])^2 / 6),   y = neighbouring means,
/// over means that start every eighth of their length, without differences beyond 3.5 sigma
/// (spikes, steps; sigma from the median at first).
///
/// Of a recording whose input rate changes, differences are taken less what an error of the scale
/// factor makes of them: constant, with temperature, nonlinear, uneven, late.
///
/// White noise: exact, error of the estimate about 0.6/sqrt(means). Ramps and any drift that bends
/// slowly against the mean do not enter. Flicker noise of coefficient B counts with 0.60 B: the
/// part that changes from mean to mean. Its slower part, like a random walk, looks like drift,
/// and is left to the models.
///
/// A recording of fewer than 30 means is judged by shorter ones, taking the noise between for
/// white. Nothing for fewer than 3 rows without a gap.
std::optional<double> noise_floor_dph(const recording::Recording& recording, double average_s);

}  // namespace fogcomp::noise
