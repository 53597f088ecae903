#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recording/board_limits.hpp"
#include "recording/recording.hpp"
#include "recording/segments.hpp"

namespace fogcomp::recording {

/// Reasons for which the board would refuse a row.
enum class Refusal : std::uint8_t {
  impossible_temperature,
  power_on_temperature,  ///< power-on value of a DS18B20
  temperature_jump,
  rate_beyond_range,
  rate_jump,
};

struct RefusedRow {
  std::size_t row;
  Refusal why;
};

/// The rows of a recording that the board would refuse, in order, each once. Uses the core's own
/// monitors (firmware/spec/samples.md), with these differences because a recording is
/// known as a whole:
///  * Between rows the temperature is assumed on a straight line if that helps: it is refused if it
///    must have changed by more than 1 degC/s, and exactly 85 degC if it must have been approached
///    by more than 12 degC/min.
///  * The first readings are judged backwards from the first one that its successor confirms.
///  * An excursion that the board would accept in the end is refused from its start if it ends
///    within 10 min faster than a coil can change.
/// A recording with 85 degC only is a soak.
std::vector<RefusedRow> refused_rows(const Recording& recording, const GyroLimits& limits);

/// Whether frozen_temperatures() can tell: readings each second or more often. Between longer ones
/// the end of a ramp looks the same.
bool judges_frozen_temperatures(const Recording& recording);

/// Ranges in which the board would call the temperature frozen for longer than it holds a drift.
std::vector<RowRange> frozen_temperatures(const Recording& recording);

}  // namespace fogcomp::recording
