#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recording/column_name.hpp"

namespace fogcomp::recording {

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

}  // namespace fogcomp::recording
