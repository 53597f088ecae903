#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recording/board_limits.hpp"
#include "recording/recording.hpp"
#include "recording/segments.hpp"

namespace fogcomp::recording {

/// Why the board would refuse a row.
enum class Refusal : std::uint8_t {
  impossible_temperature,
  power_on_temperature,  ///< what a DS18B20 says before its first conversion
  temperature_jump,
  rate_beyond_range,
  rate_jump,
};

struct RefusedRow {
  std::size_t row;
  Refusal why;
};

/// The rows of a recording that the board would refuse, in order, each once: by the core's own
/// monitors (firmware/SPEC.md, "Judging a sample"), with what a recording has and a board has not:
/// * of the samples between rows the board would have seen a straight line, where that helps: a
///   temperature is refused where it must have changed by more than 1 degC/s, and 85 degC exactly
///   where it must have been approached by more than 12 degC/min;
/// * the first readings are judged backwards from the first that its successor confirms;
/// * a temperature that the board would believe in the end, and that was left within 10 min as no
///   coil leaves one, is refused from its beginning.
/// A recording that says nothing but 85 degC is a soak.
std::vector<RefusedRow> refused_rows(const Recording& recording, const GyroLimits& limits);

/// Where the board would call the temperature frozen, for longer than it holds a drift. Only looked
/// for in rows of a second or less: in longer ones the end of a ramp looks the same.
std::vector<RowRange> frozen_temperatures(const Recording& recording);

}  // namespace fogcomp::recording
