#include "recording/csv_header.hpp"

#include <algorithm>
#include <iterator>

#include "recording/column_units.hpp"
#include "recording/columns.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::size_t kRateSlot = static_cast<std::size_t>(Column::rate_dph);
constexpr std::size_t kInputRateSlot = static_cast<std::size_t>(Column::input_rate_dph);
constexpr std::string_view kCountsName = "counts";
constexpr std::string_view kSegmentName = "segment";
constexpr std::size_t kMostNamesShown = 12;

std::string without_quotes(std::string_view name) {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  return std::string(trim(name));
}

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == kMostNamesShown) return list + ", ...";
    list += (i == 0 ? "" : ", ") + (names[i].empty() ? "(no name)" : printable(names[i]));
  }
  return list;
}

std::vector<std::string> known_names() {
  std::vector<std::string> names{std::string(kCountsName), std::string(kSegmentName)};
  for (const ColumnInfo& info : kColumns) names.emplace_back(info.name);
  return names;
}

std::size_t slot_of(std::string_view name) {
  if (name == kSegmentName) return CsvHeader::kSegmentLabel;
  for (std::size_t slot = 0; slot < kColumns.size(); ++slot) {
    if (kColumns[slot].name == name) return slot;
  }
  return CsvHeader::kIgnored;
}

void refuse_what_is_no_header(const std::vector<std::string>& names, std::string_view text,
                              const std::string& where) {
  if (text.rfind(kModelTitle, 0) == 0) {
    throw InputError(where, "a model, where a recording should be; name a recording");
  }
  if (std::all_of(names.begin(), names.end(),
                  [](const std::string& name) { return parse_number(name).has_value(); })) {
    throw InputError(where,
                     "numbers where the column names should be; put a line such as "
                     "time_s,temperature_degc,rate_dph before them");
  }
  if (text.find('\r') != std::string_view::npos) {
    throw InputError(where, "lines end in CR alone; save the file with LF or CRLF");
  }
  if (names.size() > 1) return;
  if (text.find(';') != std::string_view::npos || text.find('\t') != std::string_view::npos) {
    throw InputError(where, "columns separated by ';' or tabs; save the file with ','");
  }
}

void refuse_duplicates(const std::vector<std::string>& names, const std::string& where) {
  const std::vector<std::string> known = known_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    // First: with a header of many columns the search below is long.
    if (std::find(known.begin(), known.end(), names[i]) == known.end()) continue;
    const auto twin =
        std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]);
    if (twin == names.begin() + static_cast<std::ptrdiff_t>(i)) continue;
    throw InputError(where, "column '" + names[i] + "' stands twice, in fields " +
                                std::to_string(twin - names.begin() + 1) + " and " +
                                std::to_string(i + 1) + "; rename or remove one");
  }
}

// What a wrong name alone can be the matter with: not a column in its own right, nor another unit.
std::vector<std::string> renamable(const std::vector<std::string>& names) {
  std::vector<std::string> chosen;
  std::copy_if(names.begin(), names.end(), std::back_inserter(chosen), [](const auto& name) {
    return slot_of(name) == CsvHeader::kIgnored && !has_foreign_unit(name);
  });
  return chosen;
}

void require(const CsvHeader& header, Column column, const std::string& where) {
  if (header.has(static_cast<std::size_t>(column))) return;
  const std::string name(column_info(column).name);
  const std::string conversion = how_to_convert(column, header.names);
  if (!conversion.empty()) throw InputError(where, "no column '" + name + "': " + conversion);
  throw InputError(where, "no column '" + name + "'" + did_you_mean(name, renamable(header.names)) +
                              "; the header has " + joined(header.names) + "; rename or add it");
}

// `counts` take the place of the rate where there is a scale factor, or nothing else.
void choose_rate(CsvHeader& header, const std::string& file, const std::string& where,
                 const ReadOptions& options) {
  const auto counts = std::find(header.names.begin(), header.names.end(), kCountsName);
  const bool has_counts = counts != header.names.end();
  if (!has_counts || (header.has(kRateSlot) && !options.scale_factor)) {
    if (options.scale_factor) {
      options.watch.say(file, "no column 'counts': --scale-factor changes nothing");
    }
    return;
  }
  const auto scale_factor =
      options.scale_factor ? options.scale_factor : options.model_scale_factor;
  if (!scale_factor) {
    throw InputError(where,
                     "'counts' without a scale factor; give --scale-factor (counts per "
                     "deg/s) or a column 'rate_dph'");
  }
  std::replace(header.slots.begin(), header.slots.end(), kRateSlot, CsvHeader::kIgnored);
  header.slots[static_cast<std::size_t>(counts - header.names.begin())] = kRateSlot;
  header.dph_per_rate_unit = kDphPerDegreePerSecond / *scale_factor;
}

void name_ignored_columns(const CsvHeader& header, const std::string& file,
                          const ReadWatch& watch) {
  std::vector<std::string> ignored;
  for (std::size_t i = 0; i < header.names.size(); ++i) {
    if (header.slots[i] == CsvHeader::kIgnored) ignored.push_back(header.names[i]);
  }
  if (ignored.empty()) return;
  std::string hint;
  for (const ColumnInfo& info : kColumns) {
    if (!hint.empty() || header.has(static_cast<std::size_t>(info.column))) continue;
    hint = how_to_convert(info.column, ignored);
    if (!hint.empty()) hint = " (" + hint + ")";
  }
  if (ignored.size() == 1 && !has_foreign_unit(ignored[0])) {
    hint = did_you_mean(ignored[0], known_names());
  }
  watch.say(file, std::string("column") + (ignored.size() == 1 ? "" : "s") +
                      " ignored: " + joined(ignored) + hint);
}

}  // namespace

std::string printable(std::string_view field) {
  constexpr std::size_t kLongest = 40;
  return displayable(field.substr(0, kLongest)) + (field.size() > kLongest ? "..." : "");
}

bool CsvHeader::has(std::size_t slot) const {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

CsvHeader parse_csv_header(std::string_view text, const std::string& file, const std::string& where,
                           const ReadOptions& options) {
  CsvHeader header;
  for (const std::string& name : split(text, ',')) {
    header.names.push_back(without_quotes(trim(name)));
    header.slots.push_back(slot_of(header.names.back()));
  }
  refuse_what_is_no_header(header.names, text, where);
  refuse_duplicates(header.names, where);
  choose_rate(header, file, where, options);
  for (const Column column : {Column::time_s, Column::temperature_degc, Column::rate_dph}) {
    require(header, column, where);
  }
  name_ignored_columns(header, file, options.watch);
  if (header.has(kInputRateSlot) && options.default_input_rate_dph != 0) {
    options.watch.say(file, "its input_rate_dph is used; --latitude changes nothing");
  }
  return header;
}

}  // namespace fogcomp::recording
