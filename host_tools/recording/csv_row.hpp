#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/columns.hpp"
#include "recording/csv_layout.hpp"

namespace fogcomp::recording {

/// The fields of one line by columns, in a recording's units.
struct CsvRow {
  /// NaN where missing; the last are parts of a time (CsvHeader::kTimePart).
  std::array<double, CsvHeader::kReadSlots> values{};
  std::string_view label{};
  bool lacks_values = false;  ///< some are NaN
};

/// Reads the rows of a CSV one after another.
class CsvRowReader {
 public:
  /// `layout` must outlive this.
  explicit CsvRowReader(const CsvLayout& layout);

  /// Returns false if a field is missing, surplus or not a number; fault_of() gives the reason.
  bool read(std::string_view line, CsvRow& row) {
    if (!plain_ || !read_plain(line, row)) {
      if (!read_any(line, row)) return false;
    }
    for (const CsvHeader::Conversion& each : conversions_) {
      row.values[each.slot] = each.unit.convert(row.values[each.slot]);
    }
    if (has_time_part_) add_time_part(row);
    return true;
  }

  std::string fault_of(std::string_view line);
  /// The option with which the fields that are no numbers are some; "" if there is none.
  std::string cure_of(std::string_view line);
  /// Of the first row, seconds of its calendar, with calendar times.
  double first_date_s() const;

 private:
  bool read_plain(std::string_view line, CsvRow& row) const;
  bool read_any(std::string_view line, CsvRow& row);
  FieldKind read_time(double& value);
  void add_time_part(CsvRow& row);

  const CsvLayout& layout_;
  const std::vector<CsvHeader::Conversion>& conversions_;
  bool plain_;          ///< the fast path may be used
  bool has_time_part_;  ///< the time is in several columns
  std::string both_;    ///< a date and a time of day
  std::vector<std::string_view> fields_;
  std::optional<TimeReading> first_time_;
  std::optional<double> first_part_s_;
};

}  // namespace fogcomp::recording
