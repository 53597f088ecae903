#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recording/column_name.hpp"
#include "recording/csv_fields.hpp"

namespace fogcomp::recording {

/// Hours, minutes, seconds and a part of these.
constexpr std::size_t kMaxTimeParts = 4;

/// One part of `--columns`: assigns a column of a file to a column of a recording.
struct ColumnChoice {
  std::size_t slot = 0;  ///< as in CsvHeader::slots
  std::string name{};    ///< of the file's column, with or without a unit; or its number, from 1
};

/// Parses "time=Time[ms],temperature=Temp,rate=Gyro_X[deg/s]". Throws InputError for any other
/// text, and for a column that is named twice.
std::vector<ColumnChoice> parse_column_map(const std::string& text);

struct ChosenField {
  std::size_t field = 0;
  std::optional<Unit> unit{};  ///< given in the choice itself
  /// Of a time in several columns ("sec+nanosec"): the others.
  std::vector<ChosenField> parts{};
};

/// The column among `names` that `choice` names: by its whole name, or without its unit, ignoring
/// case and blanks; else by its number; or those whose sum is the time. Nothing if there is none;
/// throws InputError if there are several.
std::optional<ChosenField> find_field(const ColumnChoice& choice,
                                      const std::vector<ColumnName>& names);

/// The value that `choice` gives all rows, in the recording's unit: "25[degC]", "50[deg/s]".
/// Nothing if it is no number with a unit of the column, and for time and rate.
std::optional<double> constant_of(const ColumnChoice& choice);

/// A column of a file as --columns names it: by its name or, where that would not do, by its
/// number.
std::string column_choice(const std::vector<std::string>& names, std::size_t field);

/// Name of a recording's column in --columns: "time" for time_s.
std::string map_key(std::size_t slot);

/// Names of a header with their units. "h", "m" and "s" are units where two of them stand, "m"
/// among these, and "time_h", "time_m" and "time_s" where all do.
std::vector<ColumnName> column_names(const std::vector<std::string>& names,
                                     const std::vector<std::string>& units);

/// Of the `free` columns those with a date, or a time of day, in the first row. Digits alone are
/// one only if the name says so, too.
std::vector<std::size_t> columns_with(CalendarPart part, const std::vector<ColumnName>& columns,
                                      const std::vector<std::size_t>& free,
                                      const std::vector<std::string>& first_row);

/// Columns of a year, a month, a day, hours, minutes and perhaps seconds; empty unless all are.
std::vector<std::size_t> calendar_in_parts(const std::vector<ColumnName>& columns);

/// The sum that all of `times`, columns that may be the time, are: called alike and in different
/// units, with a date beside them or without. Their values have to agree (understand_times()).
std::optional<ChosenField> time_in_parts(const std::vector<ColumnName>& columns,
                                         const std::vector<std::size_t>& times,
                                         const std::vector<std::string>& first_row);

}  // namespace fogcomp::recording
