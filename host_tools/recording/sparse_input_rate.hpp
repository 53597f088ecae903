#pragma once

#include <string>
#include <vector>

#include "recording/mask.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// An input rate that holds each of its readings for two samples or more, as in a file that joins
/// two logs: leaves the readings, NaN elsewhere, and returns true. Without change, false, if it
/// changes from sample to sample or has gaps (NaN), or if the gyro (`rate_dph`) steps with it, as
/// on a table that does.
bool blank_held_readings(const std::vector<double>& time_s, const std::vector<double>& rate_dph,
                         std::vector<double>& input_rate);

/// Completes an input rate with readings in some rows only (NaN elsewhere) between readings at most
/// kHoldSeconds apart: by the cubic through the four readings around, or, beside a sudden
/// change, before or behind. (A straight line cuts the peaks: with 20 readings in a period a sine
/// would lose 0.8 %, which looks like a scale factor.) Leaves what no such cubic tells: see
/// join_by_lines().
///
/// Returns the times in which none of these curves is known as well as the gyro's own mean between
/// the two readings (`rate_dph`: the measured rate), nor as well as they are usually in this
/// record: those of changes that were over before the next reading.
std::vector<Mask> draw_input_rate(const std::vector<double>& time_s,
                                  const std::vector<double>& rate_dph,
                                  std::vector<double>& input_rate);

/// Masks times in which the input rate is not known, and says so: "fits and comparisons leave out
/// 12 s WHICH, the first at 3 s; REMEDY". Nothing without masks.
void mask_unknown_input_rate(Recording& recording, const std::vector<Mask>& unknown,
                             const std::string& which, const std::string& remedy,
                             const ReadWatch& watch);

}  // namespace fogcomp::recording
