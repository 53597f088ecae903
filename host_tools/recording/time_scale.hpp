#pragma once

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
  bool are_whole = true;  ///< numbers without a fraction
};

/// What a number in a column of times may mean.
struct TimeMeaning {
  Unit unit{};
  const TimeScale* scale = nullptr;  ///< nullptr: from power-on, or of a calendar not known
};

/// Whether a time can count from power-on: less than the longest run (rules::kMaxRunHours).
bool is_since_power_on(double number, const Unit& unit);

/// The calendar of which a number in that unit is a possible date (rules::kMinUnixTimeS to
/// kMaxUnixTimeS); nullptr if none.
const TimeScale* scale_of(double number, const Unit& unit);

/// Meanings of times without a unit: those that give a possible date and a usual period
/// (rules::kMinUsualPeriodS to kMaxUsualPeriodS). Whole numbers that count by more than one may be
/// seconds or milliseconds. Other times since power-on are in finer units, or
/// seconds of a calendar that is not known, only if they cannot be in seconds. Empty if nothing
/// fits.
std::vector<TimeMeaning> possible_meanings(const TimesSeen& times);

/// Whether times that are taken in seconds may be in milliseconds as well: whole numbers with a
/// usual period in both.
bool may_be_milliseconds(const TimesSeen& times);

/// Whether times are those of a clock, written hhmmss: as such they are evenly spaced, as numbers
/// they jump at each full minute.
bool are_of_clock(const std::vector<double>& times);

/// "s since power-on, a sample each 0.005 s".
std::string meaning_words(const TimeMeaning& meaning, const TimesSeen& times);

}  // namespace fogcomp::recording
