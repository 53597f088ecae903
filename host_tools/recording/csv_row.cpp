#include "recording/csv_row.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "recording/decimal.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

}  // namespace

CsvRowReader::CsvRowReader(const CsvLayout& layout)
    : layout_(layout),
      conversions_(layout.header.conversions),
      plain_(layout.dialect.separator != ' ' && !layout.dialect.decimal_comma &&
             layout.time == TimeFormat::number),
      has_time_part_(layout.header.has(CsvHeader::kTimePart)) {}

// Fast path for most rows: one pass over the line.
bool CsvRowReader::read_plain(std::string_view line, CsvRow& row) const {
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

bool CsvRowReader::read_any(std::string_view line, CsvRow& row) {
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
    value = kNoValue;
    row.lacks_values = true;
  }
  return true;
}

// Relative to the first row, before rounding to double.
FieldKind CsvRowReader::read_time(double& value) {
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
void CsvRowReader::add_time_part(CsvRow& row) {
  const auto first = row.values.begin() + CsvHeader::kTimePart;
  const double part_s = std::accumulate(first, row.values.end(), 0.0);
  if (!first_part_s_) first_part_s_ = layout_.time == TimeFormat::number ? 0 : part_s;
  row.values[kTimeSlot] += part_s - *first_part_s_;
}

double CsvRowReader::first_date_s() const {
  if (!first_time_) return 0;
  const double number = first_time_->number();
  const double zero_s = layout_.scale == nullptr ? 0 : layout_.scale->zero_s;
  const bool is_number = layout_.time == TimeFormat::dates;
  return (is_number ? layout_.header.unit_of(kTimeSlot).convert(number) : number) + zero_s +
         first_part_s_.value_or(0);
}

std::string CsvRowReader::cure_of(std::string_view line) {
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

std::string CsvRowReader::fault_of(std::string_view line) {
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

}  // namespace fogcomp::recording
