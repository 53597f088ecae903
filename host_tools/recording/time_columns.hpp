#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recording/column_map.hpp"
#include "recording/column_name.hpp"
#include "recording/csv_fields.hpp"

namespace fogcomp::recording {

/// Hours, minutes, seconds and a part of these.
constexpr std::size_t kMaxTimeParts = 4;

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
