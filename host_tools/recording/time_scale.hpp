#pragma once

#include <optional>
#include <vector>

#include "recording/unit_spelling.hpp"

namespace fogcomp::recording {

/// A calendar by which loggers write a time as one number.
struct TimeScale {
  const char* name;  ///< for messages: "UNIX"
  const char* unit;  ///< as --columns has it
  double zero_s;     ///< where it begins, seconds since 1970-01-01
};

/// The first times of a file, as it writes them.
struct TimesSeen {
  double first = 0;
  /// From row to row, typical and in the mean; 0 if there is one row. Packets and gaps move one of
  /// them only.
  double median_spacing = 0;
  double mean_spacing = 0;
};

/// What a number in a column of times may mean.
struct TimeMeaning {
  Unit unit{};
  const TimeScale* scale = nullptr;  ///< nullptr: counted from power-on
};

/// The calendar of which a number in that unit is a possible date (rules::kMinUnixTimeS to
/// kMaxUnixTimeS); nullptr if none.
const TimeScale* scale_of(double number, const Unit& unit);

/// Meanings of times without a unit: those that give a possible date and a usual period
/// (rules::kMinUsualPeriodS to kMaxUsualPeriodS). Seconds since power-on are finer units only if
/// they cannot be seconds. Empty if nothing fits.
std::vector<TimeMeaning> possible_meanings(const TimesSeen& times);

/// "s since power-on, a sample each 0.005 s".
std::string meaning_words(const TimeMeaning& meaning, const TimesSeen& times);

}  // namespace fogcomp::recording
