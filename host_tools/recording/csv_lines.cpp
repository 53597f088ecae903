#include "recording/csv_layout.hpp"

#include <algorithm>

#include "recording/csv_fields.hpp"
#include "recording/decision_rules.hpp"
#include "recording/unit_spelling.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

}  // namespace

std::vector<std::string_view> first_lines(const FileHead& head) {
  std::vector<std::string_view> lines;
  std::string_view rest = head.text;
  if (rest.substr(0, kUtf8Mark.size()) == kUtf8Mark) {
    rest.remove_prefix(kUtf8Mark.size());
  }
  constexpr std::size_t kMax = rules::kMaxLinesBeforeHeader + rules::kMaxRowsLookedAt;
  while (!rest.empty() && lines.size() < kMax) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos && !head.whole)
      break;  // the rest of the line has not been read
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    // A terminal adds more of them.
    while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
  }
  return lines;
}

std::string_view uncommented(std::string_view line) {
  line = trim(line);
  while (!line.empty() && (line.front() == '#' || line.front() == '%')) line.remove_prefix(1);
  return trim(line);
}

std::vector<std::string> names_in(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  split_fields(line, separator, fields);
  std::vector<std::string> names;
  for (const std::string_view field : fields) {
    // "time [s]" is split at its blank.
    const bool unit = separator == ' ' && !field.empty() && (field[0] == '[' || field[0] == '(');
    if (unit && !names.empty()) {
      names.back() += " " + std::string(field);
    } else {
      names.emplace_back(field);
    }
  }
  return names;
}

bool is_units_row(const std::vector<std::string>& fields) {
  std::size_t units = 0;
  for (const std::string& field : fields) {
    if (field.empty() || field == "-") continue;
    const std::size_t bracketed = field.front() == '[' || field.front() == '(' ? 1 : 0;
    if (field.size() < 2 * bracketed + 1 ||
        !find_unit(std::string_view(field).substr(bracketed, field.size() - 2 * bracketed))) {
      return false;
    }
    ++units;
  }
  return units > 0;
}

bool is_value(std::string_view field) {
  double value = 0;
  return read_number(field, {}, value) == FieldKind::number ||
         read_number(field, {',', true}, value) == FieldKind::number ||
         calendar_part(field) != CalendarPart::none;
}

bool is_all_numbers(const std::vector<std::string>& names) {
  return !names.empty() && std::all_of(names.begin(), names.end(),
                                       [](const std::string& name) { return is_value(name); });
}

bool is_comment_or_blank(std::string_view line) {
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  return line.empty() || line.front() == '#' || line.front() == '%';
}

std::size_t next_row(const std::vector<std::string_view>& lines, std::size_t line) {
  while (line < lines.size() && is_comment_or_blank(lines[line])) ++line;
  return line;
}

}  // namespace fogcomp::recording
