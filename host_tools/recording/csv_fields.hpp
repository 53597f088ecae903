#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace fogcomp::recording {

/// Notation of the fields of a CSV.
struct CsvDialect {
  char separator = ',';  ///< ' ': any number of blanks and tabs
  bool decimal_comma = false;
  bool groups = false;  ///< the other mark may part thousands: "12.389,5"

  char decimal_mark() const { return decimal_comma ? ',' : '.'; }
  char group_mark() const { return decimal_comma ? '.' : ','; }
};

/// Splits a line into fields, trimmed and without quotes; separators within quotes do not split.
/// Overwrites `fields`.
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);

enum class FieldKind : std::uint8_t {
  number,
  missing,  ///< empty, "NaN", "n/a", "-"
  text,
};

/// Whether an unsigned number is written in groups: one to three digits, not 0 first, then a mark
/// and three digits, once or more: "12,389".
bool is_grouped(std::string_view digits, char mark);

/// Reads a field as a finite number.
FieldKind read_number(std::string_view field, const CsvDialect& dialect, double& value);

/// A time as written in a file, in two parts, because seconds since 1970 need more digits than a
/// double has.
struct TimeReading {
  std::int64_t whole = 0;
  double fraction = 0;

  double number() const { return static_cast<double>(whole) + fraction; }
  /// This time less `other`.
  double since(const TimeReading& other) const {
    return static_cast<double>(whole - other.whole) + (fraction - other.fraction);
  }
};

/// A number in any unit; nothing if the field is not a number.
std::optional<TimeReading> read_long_number(std::string_view field, const CsvDialect& dialect);

/// What stands first in a date with the year behind, "05/03/2024". no_date: there is none,
/// but hours, minutes and seconds, "26:30:15.25".
enum class DayOrder : std::uint8_t { unknown, day_first, month_first, no_date };

/// A date and time of day in seconds since 1970; without a zone it counts as UTC. ISO 8601, with a
/// blank for the T, without seconds or zone or any sign, and what loggers make of it: "2024/3/5
/// 1:30:15 UTC", "5.3.2024 13:30", "05-Mar-2024 1:30:15 PM", "Mar 5, 2024 13:30". Dates as
/// "05/03/2024" need their order. Nothing for anything else, such as years of two digits. With
/// DayOrder::no_date hours, minutes and seconds, in seconds.
std::optional<TimeReading> read_calendar_time(std::string_view field,
                                              DayOrder order = DayOrder::unknown);

/// What a field has of such a time, in either order of day and month.
enum class CalendarPart : std::uint8_t { none, date, time_of_day, both };
CalendarPart calendar_part(std::string_view field);

/// Reads the decimal number that starts at `first` ("-12.5", "+3", ".5", "1e-3") into `value`,
/// rounded to the nearest double, and returns its end; nullptr if none starts there or it
/// overflows. `last` must be readable and be neither a digit nor a point. "inf" and "nan" are not
/// numbers.
const char* scan_decimal(const char* first, const char* last, double& value);

constexpr std::size_t kLongestDecimal = 32;

/// Prints `value` rounded to `decimals` places (0 to 10), without trailing zeros, at `out`, which
/// must have kLongestDecimal bytes; returns the end. Values above 2^53 units of the last place are
/// printed in shortest exact form.
char* print_fixed(double value, int decimals, char* out);

}  // namespace fogcomp::recording
