#include "recording/csv_layout.hpp"

#include <algorithm>
#include <utility>

namespace fogcomp::recording {
namespace {

struct ColumnMarks {
  std::string_view grouped;  // the first number with a mark
  bool has_long = false;     // a number of four digits and more without one
};

// Of each column; nothing if a number tells that the mark is the decimal one.
std::optional<std::vector<ColumnMarks>> marks_of(const std::vector<std::string_view>& lines,
                                                 const CsvLayout& layout) {
  std::vector<ColumnMarks> columns(layout.header.slots.size());
  bool is_decimal = false;
  const char mark = layout.dialect.decimal_mark();
  const auto see = [&](std::string_view field, ColumnMarks& column) {
    if (!field.empty() && (field[0] == '-' || field[0] == '+')) field.remove_prefix(1);
    const bool is_time = field.find(':') != std::string_view::npos;
    double value = 0;
    if (!is_time && read_number(field, layout.dialect, value) != FieldKind::number) return;
    if (field.find(mark) == std::string_view::npos) {
      column.has_long = column.has_long || (!is_time && field.size() > 3);
    } else if (!is_grouped(field, mark)) {
      is_decimal = true;
    } else if (column.grouped.empty()) {
      column.grouped = field;
    }
  };
  for_each_row(lines, layout, [&](std::size_t, const std::vector<std::string_view>& fields) {
    for (std::size_t field = 0; field < std::min(fields.size(), columns.size()); ++field) {
      see(fields[field], columns[field]);
    }
  });
  return is_decimal ? std::nullopt : std::optional(std::move(columns));
}

// A point between columns that commas or blanks separate is that of programs, which part no
// thousands; but counts are whole.
bool may_be_grouped(const CsvLayout& layout, std::size_t slot) {
  const CsvDialect& dialect = layout.dialect;
  const bool is_of_programs = dialect.separator == ',' || dialect.separator == ' ';
  if (!is_of_programs || dialect.decimal_comma) return true;
  const auto& all = layout.header.conversions;
  return std::any_of(all.begin(), all.end(), [&](const CsvHeader::Conversion& each) {
    return each.slot == slot && each.unit.quantity == Quantity::counts;
  });
}

}  // namespace

std::optional<InputError> refusal_of_marks(const std::vector<std::string_view>& lines,
                                           const std::string& path, const CsvLayout& layout) {
  const CsvDialect& dialect = layout.dialect;
  if (dialect.groups) return std::nullopt;
  const auto marks = marks_of(lines, layout);
  if (!marks) return std::nullopt;
  const std::vector<std::size_t>& slots = layout.header.slots;
  std::size_t field = 0;
  for (; field < slots.size(); ++field) {
    const ColumnMarks& column = (*marks)[field];
    const bool is_read = slots[field] < CsvHeader::kReadSlots;
    if (is_read && !column.grouped.empty() && !column.has_long &&
        may_be_grouped(layout, slots[field])) {
      break;
    }
  }
  if (field == slots.size()) return std::nullopt;
  const std::string number((*marks)[field].grouped);
  std::string decimal = number;
  std::string whole = number;
  const std::size_t at = number.find(dialect.decimal_mark());
  decimal[at] = '.';
  whole.erase(at, 1);
  return InputError(path, "numbers such as " + number + " (column " + std::to_string(field + 1) +
                              " '" + printable(layout.header.names[field]) + "') can be " +
                              decimal + " or " + whole +
                              "; say which mark is the decimal one: --decimal-mark " +
                              (dialect.decimal_comma ? "comma or point" : "point or comma"));
}

}  // namespace fogcomp::recording
