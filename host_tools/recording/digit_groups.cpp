#include "recording/csv_layout.hpp"

#include <algorithm>

namespace fogcomp::recording {
namespace {

/// What the marks in the numbers of a file can be.
class Marks {
 public:
  Marks(const std::vector<std::string_view>& lines, const CsvLayout& layout)
      : layout_(layout), columns_(layout.header.slots.size()) {
    for_each_row(lines, layout, [&](std::size_t, const std::vector<std::string_view>& fields) {
      for (std::size_t field = 0; field < std::min(fields.size(), columns_.size()); ++field) {
        see(fields[field], columns_[field]);
      }
    });
  }

  // Of the columns that are read; nothing if the mark can be the decimal one only.
  std::optional<std::size_t> ambiguous_column() const {
    if (is_decimal_) return std::nullopt;
    for (std::size_t field = 0; field < columns_.size(); ++field) {
      if (layout_.header.slots[field] >= CsvHeader::kReadSlots || !may_be_grouped(field)) continue;
      if (!columns_[field].grouped.empty() && !columns_[field].has_long) return field;
    }
    return std::nullopt;
  }
  std::string_view example(std::size_t field) const { return columns_[field].grouped; }

 private:
  // A point between columns that commas or blanks separate is that of programs, which part no
  // thousands; but counts are whole.
  bool may_be_grouped(std::size_t field) const {
    const CsvDialect& dialect = layout_.dialect;
    const bool is_of_programs = dialect.separator == ',' || dialect.separator == ' ';
    if (!is_of_programs || dialect.decimal_comma) return true;
    const auto& all = layout_.header.conversions;
    return std::any_of(all.begin(), all.end(), [&](const CsvHeader::Conversion& each) {
      return each.slot == layout_.header.slots[field] && each.unit.quantity == Quantity::counts;
    });
  }

  struct ColumnMarks {
    std::string_view grouped;  // the first number with a mark
    bool has_long = false;     // a number of four digits and more without one
  };

  void see(std::string_view field, ColumnMarks& column) {
    if (!field.empty() && (field[0] == '-' || field[0] == '+')) field.remove_prefix(1);
    const char mark = layout_.dialect.decimal_mark();
    const std::size_t at = field.find(mark);
    const bool is_time = field.find(':') != std::string_view::npos;
    double value = 0;
    if (!is_time && read_number(field, layout_.dialect, value) != FieldKind::number) return;
    if (at == std::string_view::npos) {
      column.has_long = column.has_long || (!is_time && field.size() > 3);
    } else if (!is_grouped(field, mark)) {
      is_decimal_ = true;
    } else if (column.grouped.empty()) {
      column.grouped = field;
    }
  }

  const CsvLayout& layout_;
  std::vector<ColumnMarks> columns_;
  bool is_decimal_ = false;
};

}  // namespace

std::optional<InputError> refusal_of_marks(const std::vector<std::string_view>& lines,
                                           const std::string& path, const CsvLayout& layout) {
  const CsvDialect& dialect = layout.dialect;
  if (dialect.groups) return std::nullopt;
  const Marks marks(lines, layout);
  const auto field = marks.ambiguous_column();
  if (!field) return std::nullopt;
  const std::string number(marks.example(*field));
  std::string decimal = number;
  std::string whole = number;
  const std::size_t at = number.find(dialect.decimal_mark());
  decimal[at] = '.';
  whole.erase(at, 1);
  return InputError(path, "numbers such as " + number + " (column " + std::to_string(*field + 1) +
                              " '" + printable(layout.header.names[*field]) + "') can be " +
                              decimal + " or " + whole +
                              "; say which mark is the decimal one: --decimal-mark " +
                              (dialect.decimal_comma ? "comma or point" : "point or comma"));
}

}  // namespace fogcomp::recording
