#include "recording/csv_layout.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "recording/column_map.hpp"
#include "recording/column_name.hpp"
#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "recording/row_filter.hpp"
#include "recording/unit_spelling.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::size_t kRequired = 3;  // time, temperature, rate
constexpr char kSeparators[] = {',', ';', '\t', '|', ' '};

/// A line that may be the header, parted by `separator`.
struct LikelyHeader {
  std::vector<std::string> names{};
  char separator = ',';
  std::size_t line = 0;
  std::size_t found = 0;    ///< required columns among the names
  bool is_numbers = false;  ///< a first row instead

  std::size_t first_row() const { return is_numbers ? line : line + 1; }
  /// The larger, the likelier: of lines that have as many of the three the first one that has
  /// enough fields, parted so that it has most.
  std::tuple<std::size_t, bool, bool, std::ptrdiff_t, std::size_t> rank() const {
    return {found, !is_numbers, names.size() >= kRequired, -static_cast<std::ptrdiff_t>(line),
            names.size()};
  }
};

// "tabs", "blanks" or "';'".
std::string separator_words(char separator) {
  if (separator == '\t') return "tabs";
  return separator == ' ' ? "blanks" : std::string("'") + separator + "'";
}

CsvColumns::Column described_column(const LikelyHeader& likeliest, const CsvHeader* header,
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

// Columns, first rows and separator. `header`: as understood; nullptr: what the names suggest.
CsvColumns columns_in(const LikelyHeader& likeliest, const CsvHeader* header,
                      const std::vector<std::string_view>& lines) {
  constexpr std::size_t kRowsShown = 3;
  CsvColumns found;
  found.separator = separator_words(likeliest.separator);
  for (std::size_t i = 0; i < likeliest.names.size(); ++i) {
    found.columns.push_back(described_column(likeliest, header, i));
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

/// A possible interpretation of a file, and how well its first rows fit it.
struct Reading {
  CsvLayout layout;
  HeaderLines lines;
  std::size_t rows = 0;
  std::size_t good_rows = 0;
  bool first_is_good = false;
  std::vector<double> values{};  ///< of the good rows, to compare two interpretations
  bool has_values() const { return rows > 0 && good_rows == rows; }
};

class LayoutFinder {
 public:
  LayoutFinder(const FileHead& head, const ReadOptions& options)
      : head_(head), options_(options), lines_(first_lines(head)) {
    silent_.watch = {};
  }

  CsvLayout find() {
    refuse_other_texts();
    for (const bool in_comments : {false, true}) {
      for (const char separator : kSeparators) {
        look_for_header(separator, in_comments);
        if (is_plain()) return finish(readings_.front());
      }
      if (std::any_of(readings_.begin(), readings_.end(), fits)) break;
    }
    return finish(best());
  }

  CsvColumns columns() {
    std::string refusal;
    std::optional<CsvLayout> layout;
    try {
      layout = find();
    } catch (const InputError& error) {
      refusal = error.what();
    }
    if (layout) {
      likeliest_ = {layout->header.names, layout->dialect.separator, layout->lines_before_rows - 1};
    }
    CsvColumns found = columns_in(likeliest_, layout ? &layout->header : nullptr, lines_);
    found.refusal = std::move(refusal);
    return found;
  }

 private:
  static bool fits(const Reading& reading) { return reading.has_values(); }

  std::string place(std::size_t line) const { return head_.path + ":" + std::to_string(line + 1); }
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw InputError(place(line), what);
  }

  void refuse_other_texts() const {
    if (lines_.empty()) return;
    if (lines_[0].rfind(kModelTitle, 0) == 0) {
      fail(0, "a model, where a recording should be; name a recording");
    }
    if (lines_[0].find('\r') != std::string_view::npos) {
      fail(0, "lines end with CR only; save the file with LF or CRLF");
    }
  }

  // Interpretations with each line that may be the header, for this separator.
  void look_for_header(char separator, bool in_comments) {
    const std::size_t end = std::min(lines_.size(), rules::kMaxLinesBeforeHeader);
    for (std::size_t i = 0; i < end; ++i) {
      if (trim(lines_[i]).empty() || is_comment_or_blank(lines_[i]) != in_comments) continue;
      const std::string_view text = in_comments ? uncommented(lines_[i]) : lines_[i];
      if (text.find(separator) == std::string_view::npos) continue;
      std::vector<std::string> names = names_in(text, separator);
      const bool is_data = is_all_numbers(names) || has_numbers_as_names(names);
      const std::size_t found = is_data ? 0 : required_columns_among(names, options_);
      const LikelyHeader one{names, separator, i, found, is_all_numbers(names)};
      if (likeliest_.names.empty() || one.rank() > likeliest_.rank()) likeliest_ = one;
      if (found < kRequired) continue;
      const std::size_t before = readings_.size();
      i = try_header(i, separator, std::move(names));
      // A header stands before the rows: one that comes again is none.
      const auto begun = readings_.begin() + static_cast<std::ptrdiff_t>(before);
      if (std::any_of(begun, readings_.end(), [](const auto& each) { return each.first_is_good; }))
        return;
    }
  }

  // Whether --columns gives numbers of columns, and this line has numbers there.
  bool has_numbers_as_names(const std::vector<std::string>& names) const {
    if (options_.columns.empty()) return false;
    const std::vector<ColumnName> columns(names.begin(), names.end());
    bool any = false;
    for (const ColumnChoice& choice : parse_column_map(options_.columns)) {
      const auto chosen = find_field(choice, columns);
      if (!chosen) continue;
      if (!is_value(without_quotes(names[chosen->field]))) return false;
      any = true;
    }
    return any;
  }

  // Returns the last line of the header: a row of units belongs to it.
  std::size_t try_header(std::size_t line, char separator, std::vector<std::string> names) {
    HeaderLines header{std::move(names), {}, head_.path, place(line)};
    std::size_t last = line;
    const std::size_t below = next_line(line + 1);
    if (below < lines_.size()) {
      std::vector<std::string> fields = names_in(lines_[below], separator);
      header = without_empty_names(std::move(header), fields.size());
      while (fields.size() > header.names.size() && fields.back().empty()) fields.pop_back();
      if (fields.size() == header.names.size() && is_units_row(fields)) {
        header.units = std::move(fields);
        last = below;
      }
    }
    try_header(header, separator, last + 1);
    return last;
  }

  // Of a header line that ends in a separator, unlike its rows.
  static HeaderLines without_empty_names(HeaderLines header, std::size_t fields) {
    while (fields < header.names.size() &&
           (header.names.back().empty() || header.names.back() == "Comment")) {  // of LabVIEW
      header.names.pop_back();
    }
    if (header.units.size() > header.names.size()) header.units.resize(header.names.size());
    return header;
  }

  // Of the first row, whose line ends in separators, as all others must then.
  static std::size_t empty_behind(const std::vector<std::string>& fields, std::size_t names) {
    if (fields.size() <= names) return 0;
    const bool are_empty = std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(names),
                                       fields.end(), [](const auto& each) { return each.empty(); });
    return are_empty ? fields.size() - names : 0;
  }

  void try_header(HeaderLines header, char separator, std::size_t lines_before_rows) {
    const std::size_t first = next_line(lines_before_rows);
    std::vector<std::string> fields;
    if (first < lines_.size()) fields = names_in(lines_[first], separator);
    if (!fields.empty()) header = without_empty_names(std::move(header), fields.size());
    header.first_row = fields;
    CsvLayout layout;
    layout.lines_before_rows = lines_before_rows;
    layout.dialect.separator = separator;
    try {
      layout.header = understand_header(header, silent_);
    } catch (const InputError& error) {
      if (!refusal_) refusal_ = error;
      return;
    }
    layout.header.empty_behind = empty_behind(fields, header.names.size());
    layout.dialect.groups = options_.decimal_comma.has_value();
    for (const bool decimal_comma : {false, true}) {
      if (options_.decimal_comma && *options_.decimal_comma != decimal_comma) continue;
      layout.dialect.decimal_comma = decimal_comma;
      Reading reading{layout, header};
      try_rows(reading);
      // Whole numbers are the same with either decimal mark.
      if (decimal_comma && reading.has_values() && !readings_.empty() &&
          readings_.back().has_values()) {
        continue;
      }
      readings_.push_back(std::move(reading));
    }
  }

  std::size_t next_line(std::size_t line) const { return next_row(lines_, line); }

  void try_rows(Reading& reading) const {
    for_each_row(lines_, reading.layout, [&](std::size_t, const auto& fields) {
      if (reading.rows == rules::kMaxRowsLookedAt) return;
      ++reading.rows;
      if (is_good(fields, reading)) ++reading.good_rows;
      if (reading.rows == 1) reading.first_is_good = reading.good_rows == 1;
    });
  }

  static bool is_good(const std::vector<std::string_view>& fields, Reading& reading) {
    const CsvHeader& header = reading.layout.header;
    std::string both;
    if (!header.takes_row_of(fields)) return false;
    for (std::size_t i = 0; i < header.slots.size(); ++i) {
      if (header.slots[i] >= kColumns.size()) continue;
      double value = 0;
      const FieldKind kind = read_number(fields[i], reading.layout.dialect, value);
      const bool calendar = header.slots[i] == kTimeSlot &&
                            (calendar_part(header.time_of(fields, both)) == CalendarPart::both ||
                             read_calendar_time(header.time_of(fields, both), DayOrder::no_date));
      if (kind == FieldKind::text && !calendar) return false;
      if (kind == FieldKind::number) reading.values.push_back(value);
    }
    return true;
  }

  // The plain format: no other has to be tried.
  bool is_plain() const {
    if (readings_.empty()) return false;
    const Reading& reading = readings_.front();
    return reading.layout.dialect.separator == ',' && reading.layout.header.understood.empty() &&
           !reading.layout.dialect.decimal_comma &&
           std::all_of(readings_.begin() + 1, readings_.end(),
                       [&](const Reading& other) { return other.good_rows < reading.good_rows; });
  }

  const Reading& best() {
    const auto fitting = std::find_if(readings_.begin(), readings_.end(), fits);
    if (fitting != readings_.end()) {
      const auto other = std::find_if(fitting + 1, readings_.end(), [&](const Reading& each) {
        return fits(each) && each.values != fitting->values;
      });
      if (other != readings_.end()) refuse_two(*fitting, *other);
      return *fitting;
    }
    read_without_header();
    if (readings_.empty()) explain();
    // Bad rows are reported when they are read.
    return *std::max_element(readings_.begin(), readings_.end(), [](const auto& a, const auto& b) {
      return a.good_rows < b.good_rows;
    });
  }

  [[noreturn]] void refuse_two(const Reading& one, const Reading& other) const {
    throw InputError(head_.path, "can be read in two ways: " + words(one.layout.dialect) + ", or " +
                                     words(other.layout.dialect) +
                                     "; save it with ';' between columns and '.' in numbers");
  }

  static std::string words(const CsvDialect& dialect) {
    return "columns separated by " + separator_words(dialect.separator) +
           (dialect.decimal_comma ? ", decimal comma" : "");
  }

  // A file without header, whose columns --columns gives by their numbers.
  void read_without_header() {
    const std::size_t first = next_line(0);
    if (options_.columns.empty() || first == lines_.size()) return;
    std::vector<Reading> with_header = std::exchange(readings_, {});
    for (const char separator : kSeparators) {
      const std::vector<std::string> fields = names_in(lines_[first], separator);
      if (fields.size() < 2) continue;
      const std::vector<std::string> nameless(fields.size());
      if (required_columns_among(nameless, options_) < kRequired) continue;
      try_header({nameless, {}, head_.path, head_.path}, separator, first);
    }
    readings_.erase(std::remove_if(readings_.begin(), readings_.end(),
                                   [](const Reading& each) { return !each.has_values(); }),
                    readings_.end());
    if (readings_.empty()) readings_ = std::move(with_header);
  }

  // Says why no line can be the header.
  [[noreturn]] void explain() const {
    if (refusal_) throw InputError(*refusal_);
    const std::size_t first = next_line(0);
    if (first == lines_.size()) {
      throw InputError(head_.path, "has no header line and no samples; is it the right file?");
    }
    if (likeliest_.is_numbers) {
      fail(first,
           "numbers where the column names should be; put a line such as "
           "time_s,temperature_degc,rate_dph before them, or give "
           "--columns 'time=1[s],temperature=2[degC],rate=3[deg/h]'");
    }
    const bool any = !likeliest_.names.empty();
    const std::string where = place(any ? likeliest_.line : first);
    understand_header({any ? likeliest_.names : std::vector{std::string(trim(lines_[first]))},
                       {},
                       head_.path,
                       where},
                      silent_);
    throw InputError(where, "is no header of a recording");
  }

  CsvLayout finish(const Reading& chosen) {
    CsvLayout layout = chosen.layout;
    if (const auto refusal = refusal_of_marks(lines_, head_.path, layout)) {
      if (!options_.model_decimal_comma) throw InputError(*refusal);
      ReadOptions remembered = options_;
      remembered.decimal_comma = options_.model_decimal_comma;
      return LayoutFinder(head_, remembered).find();
    }
    refuse_row_names(layout);
    refuse_several_sensors(lines_, head_.path, layout, options_);
    understand_header(chosen.lines, options_);  // to report its interpretation
    understand_times(lines_, head_.path, layout);
    refuse_second_times(lines_, head_.path, layout);
    std::vector<std::string> understood = layout.header.understood;
    if (layout.dialect.separator != ',' || layout.dialect.decimal_comma) {
      understood.push_back(words(layout.dialect));
    }
    if (!chosen.lines.units.empty()) understood.emplace_back("a row of units");
    if (head_.utf16) understood.emplace_back("UTF-16");
    if (!layout.knows_power_on()) {
      understood.push_back(std::string(words_of_times(layout)) +
                           " times, counted from the first sample: power-on is not known");
    }
    if (!understood.empty()) options_.watch.say(head_.path, "read as " + join(understood, "; "));
    return layout;
  }

  static const char* words_of_times(const CsvLayout& layout) {
    const DayOrder order = layout.header.day_order;
    if (order == DayOrder::day_first) return "day/month/year";
    if (order == DayOrder::month_first) return "month/day/year";
    return layout.scale == nullptr ? "calendar" : layout.scale->name;
  }

  // A row with a field more than the header has names, which is empty: nothing stands there. But if
  // the first field counts rows, that one may be without a name, and the last column empty.
  void refuse_row_names(const CsvLayout& layout) const {
    const std::size_t last = layout.header.slots.back();
    if (last == kTimeSlot || last == kTemperatureSlot || last == kRateSlot) return;
    std::optional<double> before;
    bool are_numbers = true;
    for_each_row(lines_, layout, [&](std::size_t, const auto& fields) {
      const std::optional<double> number = parse_number(std::string(fields.front()));
      are_numbers = are_numbers && number && fields.size() == layout.header.slots.size() + 1 &&
                    (!before || *number == *before + 1);
      before = number;
    });
    if (!are_numbers) return;
    fail(next_line(layout.lines_before_rows),
         "a field more than the header has names: is the last one empty, or is the first one the "
         "number of the row, without a name? correct the header");
  }

  const FileHead& head_;
  const ReadOptions& options_;
  ReadOptions silent_ = options_;
  std::vector<std::string_view> lines_;
  std::vector<Reading> readings_;
  std::optional<InputError> refusal_;  // for the first header with all columns
  LikelyHeader likeliest_;
};

}  // namespace

CsvColumns look_at_columns(const FileHead& head, const ReadOptions& options) {
  return LayoutFinder(head, options).columns();
}

CsvLayout find_csv_layout(const FileHead& head, const ReadOptions& options) {
  return LayoutFinder(head, options).find();
}

std::vector<std::string_view> first_lines(const FileHead& head) {
  std::vector<std::string_view> lines;
  std::string_view rest = head.text;
  constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
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
