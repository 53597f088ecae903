#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "recording/csv_layout.hpp"
#include "support/text.hpp"

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
  explicit CsvRowReader(const CsvLayout& layout)
      : layout_(layout),
        conversions_(layout.header.conversions),
        plain_(layout.dialect.separator != ' ' && !layout.dialect.decimal_comma &&
               layout.time == TimeFormat::number),
        has_time_part_(layout.header.has(CsvHeader::kTimePart)) {}

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

  std::string fault_of(std::string_view line) {
    const CsvHeader& header = layout_.header;
    split_fields(line, layout_.dialect.separator, fields_);
    if (!header.takes_row_of(fields_)) {
      const bool two_uses =
          layout_.dialect.separator == ',' && fields_.size() > header.slots.size() + 1;
      return counted(fields_.size(), "field") + " where the header has " +
             std::to_string(header.slots.size()) +
             (two_uses ? " (a ',' within numbers? separate columns by ';')" : "");
    }
    for (std::size_t i = 0; i < header.slots.size(); ++i) {
      if (header.slots[i] >= CsvHeader::kReadSlots) continue;
      double value = 0;
      const bool calendar = header.slots[i] == kTimeSlot && layout_.time == TimeFormat::calendar;
      const std::string_view time = calendar ? header.time_of(fields_, both_) : fields_[i];
      if (calendar && !read_calendar_time(time, header.day_order)) {
        return "time is '" + printable(time) + "', no date and time";
      }
      if (calendar || read_number(fields_[i], layout_.dialect, value) != FieldKind::text) {
        continue;
      }
      return header.names[i] + " is '" + printable(fields_[i]) + "', not a finite number";
    }
    return "not a row of numbers";
  }

  /// The option with which the fields that are no numbers are some; "" if there is none.
  std::string cure_of(std::string_view line) {
    const CsvHeader& header = layout_.header;
    CsvDialect with_groups = layout_.dialect;
    with_groups.groups = true;
    split_fields(line, layout_.dialect.separator, fields_);
    if (layout_.dialect.groups || !header.takes_row_of(fields_)) return "";
    bool any = false;
    for (std::size_t i = 0; i < header.slots.size(); ++i) {
      double value = 0;
      if (header.slots[i] >= CsvHeader::kReadSlots ||
          (header.slots[i] == kTimeSlot && layout_.time == TimeFormat::calendar) ||
          read_number(fields_[i], layout_.dialect, value) != FieldKind::text) {
        continue;
      }
      if (read_number(fields_[i], with_groups, value) != FieldKind::number) return "";
      any = true;
    }
    if (!any) return "";
    return std::string("give --decimal-mark ") + (with_groups.decimal_comma ? "comma" : "point");
  }

  /// Of the first row, seconds of its calendar, with calendar times.
  double first_date_s() const {
    if (!first_time_) return 0;
    const double number = first_time_->number();
    const double zero_s = layout_.scale == nullptr ? 0 : layout_.scale->zero_s;
    const bool is_number = layout_.time == TimeFormat::dates;
    return (is_number ? layout_.header.unit_of(kTimeSlot).convert(number) : number) + zero_s +
           first_part_s_.value_or(0);
  }

 private:
  // Fast path for most rows: one pass over the line.
  bool read_plain(std::string_view line, CsvRow& row) const {
    const char* p = line.data();
    const char* const end = p + line.size();
    const char separator = layout_.dialect.separator;
    const auto is_space = [&](char c) { return c == ' ' || (c == '\t' && separator != '\t'); };
    const std::vector<std::size_t>& slots = layout_.header.slots;
    for (std::size_t field = 0; field < slots.size(); ++field) {
      const std::size_t slot = slots[field];
      if (slot < row.values.size()) {
        while (p < end && is_space(*p)) ++p;
        p = scan_decimal(p, end, row.values[slot]);
        if (p == nullptr) return false;
        while (p < end && is_space(*p)) ++p;
      } else {
        const char* const start = p;
        p = std::find(p, end, separator);
        const std::string_view text{start, static_cast<std::size_t>(p - start)};
        if (text.find('"') != std::string_view::npos) return false;
        if (slot == CsvHeader::kSegmentLabel) row.label = trim(text);
      }
      const bool last = field + 1 == slots.size();
      if (last != (p == end)) return false;
      if (!last && *p++ != separator) return false;
    }
    return true;
  }

  bool read_any(std::string_view line, CsvRow& row) {
    split_fields(line, layout_.dialect.separator, fields_);
    const std::vector<std::size_t>& slots = layout_.header.slots;
    if (!layout_.header.takes_row_of(fields_)) return false;
    row.lacks_values = false;
    for (std::size_t field = 0; field < slots.size(); ++field) {
      const std::size_t slot = slots[field];
      if (slot == CsvHeader::kSegmentLabel) row.label = fields_[field];
      if (slot >= row.values.size()) continue;
      double& value = row.values[slot];
      const FieldKind kind = slot == kTimeSlot && layout_.time != TimeFormat::number
                                 ? read_time(value)
                                 : read_number(fields_[field], layout_.dialect, value);
      if (kind == FieldKind::text) return false;
      if (kind == FieldKind::number) continue;
      value = std::numeric_limits<double>::quiet_NaN();
      row.lacks_values = true;
    }
    return true;
  }

  // Relative to the first row, before rounding to double.
  FieldKind read_time(double& value) {
    const std::string_view field = layout_.header.time_of(fields_, both_);
    const auto reading = layout_.time == TimeFormat::calendar
                             ? read_calendar_time(field, layout_.header.day_order)
                             : read_long_number(field, layout_.dialect);
    if (!reading) {
      double none = 0;
      const FieldKind kind = read_number(field, {}, none);
      return kind == FieldKind::missing ? kind : FieldKind::text;
    }
    if (!first_time_) first_time_ = reading;
    value = reading->since(*first_time_);
    return FieldKind::number;
  }

  // Times of a calendar are relative to the first row, in all columns.
  void add_time_part(CsvRow& row) {
    const auto first = row.values.begin() + CsvHeader::kTimePart;
    const double part_s = std::accumulate(first, row.values.end(), 0.0);
    if (!first_part_s_) first_part_s_ = layout_.time == TimeFormat::number ? 0 : part_s;
    row.values[kTimeSlot] += part_s - *first_part_s_;
  }

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
