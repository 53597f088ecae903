#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recording/column_name.hpp"

namespace fogcomp::recording {

/// What `--columns` says: which column of a file is which of a recording.
struct ColumnChoice {
  std::size_t slot = 0;  ///< as CsvHeader::slots has it
  std::string name{};  ///< of the file's column, maybe with a unit behind it; or its number, from 1
};

/// Reads "time=Time[ms],temperature=Temp,rate=Gyro_X[deg/s]". Throws InputError for anything else,
/// and for a column that is named twice.
std::vector<ColumnChoice> parse_column_map(const std::string& text);

struct ChosenField {
  std::size_t field = 0;
  std::optional<Unit> unit{};  ///< that the choice itself gives
};

/// The column that `choice` names among `names`: the whole name, or without its unit, without
/// regard to case and blanks; else its number. Nothing where there is none; throws InputError where
/// there are several.
std::optional<ChosenField> find_field(const ColumnChoice& choice,
                                      const std::vector<ColumnName>& names);

/// How --columns names a column that a recording has, "time" for time_s.
std::string map_key(std::size_t slot);

}  // namespace fogcomp::recording
