#include "recording/csv_layout.hpp"

#include "recording/column_map.hpp"
#include "recording/column_name.hpp"
#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "recording/csv_lines.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

CsvColumns::Column column_of(const LikelyHeader& likeliest, const CsvHeader* header,
                             std::size_t field) {
  const ColumnName name(likeliest.is_numbers ? "" : likeliest.names[field]);
  const auto meaning = name.meaning();
  const std::size_t slot = header != nullptr ? header->slots[field]
                           : meaning         ? meaning->slot
                                             : CsvHeader::kIgnored;
  return {displayable(name.text),
          likeliest.is_numbers ? std::to_string(field + 1) : column_choice(likeliest.names, field),
          slot < kColumns.size() ? map_key(slot) : "", name.unit ? name.unit->words : ""};
}

}  // namespace

std::string separator_words(char separator) {
  if (separator == '\t') return "tabs";
  return separator == ' ' ? "blanks" : std::string("'") + separator + "'";
}

CsvColumns columns_in(const LikelyHeader& likeliest, const CsvHeader* header,
                      const std::vector<std::string_view>& lines) {
  constexpr std::size_t kRowsShown = 3;
  CsvColumns found;
  found.separator = separator_words(likeliest.separator);
  for (std::size_t i = 0; i < likeliest.names.size(); ++i) {
    found.columns.push_back(column_of(likeliest, header, i));
  }
  for (std::size_t i = next_row(lines, likeliest.first_row());
       i < lines.size() && found.rows.size() < kRowsShown; i = next_row(lines, i + 1)) {
    std::vector<std::string_view> fields;
    split_fields(lines[i], likeliest.separator, fields);
    std::vector<std::string>& row = found.rows.emplace_back();
    for (const std::string_view field : fields) row.push_back(printable(field));
  }
  return found;
}

}  // namespace fogcomp::recording
