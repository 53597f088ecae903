#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/column_name.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// What the fields of a CSV's rows mean, from its names.
struct CsvHeader {
  /// Special values of `slots`; all others index kColumns.
  static constexpr std::size_t kIgnored = 100;
  static constexpr std::size_t kSegmentLabel = 101;

  std::vector<std::string> names;  ///< as in the file, one per field
  std::vector<std::size_t> slots;  ///< of each field
  /// How a slot's values become a recording's; a slot that needs nothing is not among them.
  struct Conversion {
    std::size_t slot;
    Unit unit;
  };
  std::vector<Conversion> conversions;
  bool time_has_unit = true;
  /// What was understood of names that are not a recording's own: "rate: column 4 'Gyro_X [deg/s]'
  /// x 3600; ...". Empty for the plain format.
  std::vector<std::string> understood;

  bool has(std::size_t slot) const;
  std::size_t field_of(std::size_t slot) const;
};

/// The header of a file: the names of its columns, and what a row of units below says of them.
struct HeaderLines {
  std::vector<std::string> names;
  std::vector<std::string> units{};  ///< empty where there is no such row
  std::string file{};
  std::string where{};  ///< `FILE:LINE` of the names
};

/// Gives every field its meaning: what options.columns says, else a recording's own names, else
/// names that people use. Throws InputError for a duplicate or missing column, for two that could
/// be the same one, a rate without a unit, or `counts` without a scale factor. Unknown columns, and
/// options that this file makes void, are told to options.watch.
CsvHeader understand_header(const HeaderLines& lines, const ReadOptions& options);

/// How many of time, temperature and rate such names could be, 0 to 3.
std::size_t required_columns_among(const std::vector<std::string>& names,
                                   const ReadOptions& options);

/// `field` as a message may show it: displayable(), and at most 40 bytes of it.
std::string printable(std::string_view field);

}  // namespace fogcomp::recording
