#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/column_map.hpp"
#include "recording/column_name.hpp"
#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Meanings of the fields of a CSV's rows, from its names.
struct CsvHeader {
  /// Special values of `slots`; all others index kColumns.
  static constexpr std::size_t kIgnored = 100;
  static constexpr std::size_t kSegmentLabel = 101;
  /// Behind the last column of a recording, kMaxTimeParts of them: of a time in several columns
  /// ("sec", "nanosec"), those that are added to the first one.
  static constexpr std::size_t kTimePart = kColumns.size();
  static constexpr std::size_t kReadSlots = kTimePart + kMaxTimeParts;
  /// A part of the date of a time that has the rest in its own column.
  static constexpr std::size_t kDate = 102;

  std::vector<std::string> names;  ///< as in the file, one per field
  std::vector<std::size_t> slots;  ///< of each field
  /// Conversion of a slot's values; slots without conversion are not listed.
  struct Conversion {
    std::size_t slot;
    Unit unit;
  };
  std::vector<Conversion> conversions;
  /// Of slots that no field has: one value for all rows.
  struct Constant {
    std::size_t slot;
    double value;
  };
  std::vector<Constant> constants;
  bool time_has_unit = true;
  bool time_is_chosen = false;  ///< by --columns or the model
  bool input_rate_is_chosen = false;
  DayOrder day_order = DayOrder::unknown;
  /// Interpretation of names that are not a recording's own: "rate: column 4 'Gyro_X [deg/s]' x
  /// 3600; ...". Empty for the plain format.
  std::vector<std::string> understood;

  /// Whether a field has it.
  bool has(std::size_t slot) const;
  bool is_constant(std::size_t slot) const;
  std::size_t field_of(std::size_t slot) const;
  /// Of a slot of time or rate; s or deg/h if it is not converted.
  Unit unit_of(std::size_t slot) const;
  /// Fields of a date and a time of day: of both, of the date alone (to which parts are added), or
  /// from the year on.
  std::vector<std::size_t> calendar{};
  /// A row's time as written; of several columns the date before the time of day, in `both`.
  std::string_view time_of(const std::vector<std::string_view>& fields, std::string& both) const;
  /// Empty fields behind the names in each row, whose lines end in separators: they are nothing.
  std::size_t empty_behind = 0;
  /// Whether a row has a field for each name, and these.
  bool takes_row_of(const std::vector<std::string_view>& fields) const;
};

/// Header of a file: names of its columns, and units in a row below, if any.
struct HeaderLines {
  std::vector<std::string> names;
  std::vector<std::string> units{};  ///< empty without such a row
  std::string file{};
  std::string where{};                   ///< `FILE:LINE` of the names
  std::vector<std::string> first_row{};  ///< fields of the first row, if there is one
};

/// Determines the meaning of every field, and the columns that are one value: from options.columns,
/// else a recording's own names, else common names. Throws InputError for a duplicate, missing or
/// ambiguous column, a rate without a unit, or `counts` without a scale factor. Reports unknown
/// columns, and options without effect on this file, to options.watch.
CsvHeader understand_header(const HeaderLines& lines, const ReadOptions& options);

/// Number of time, temperature and rate that these names can provide, 0 to 3.
std::size_t required_columns_among(const std::vector<std::string>& names,
                                   const ReadOptions& options);

/// `field` for a message: displayable(), at most 40 bytes.
std::string printable(std::string_view field);

}  // namespace fogcomp::recording
