#include "recording/column_name.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include "recording/columns.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

// Splits at a capital after a small letter: "TimeUS", "coilTemp".
std::string split_camel_case(const std::string& text) {
  std::string result;
  char before = 0;
  for (const char c : text) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    if (is_capital && before >= 'a' && before <= 'z') result += '_';
    result += before = c;
  }
  return result;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : folded(text) + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, ""));
    }
  }
  return words;
}

// "ms", "seconds", "deg/s" are units; "T", "d" and "h" are names.
bool is_unit_alone(const std::string& key) {
  return is_unambiguous(key) || key == "s" || key == "ms" || key == "us" || key == "ns";
}

// A number before a unit, "0.01 deg/s", that is not a digit alone, which numbers a sensor.
bool is_factor(std::string_view name) {
  const std::string_view last = name.substr(name.find_last_of("_ ,:;(*") + 1);
  return last.size() > 1 && parse_number(last);
}

bool is_numeral(char c) {
  return c >= '0' && c <= '9';
}

// From `at` on; digits, a point, and a power: "1000", "0.1", "1e-3", "10^-3".
std::size_t end_of_number(const std::string& text, std::size_t at) {
  const auto digits = [&] {
    while (at < text.size() &&
           (is_numeral(text[at]) || (text[at] == '.' && is_numeral(text[at + 1]))))
      ++at;
    return at;
  };
  const std::size_t end = digits();
  if (end == text.size() || (text[end] != 'e' && text[end] != '^')) return end;
  at = end + 1;
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  const std::size_t first = at;
  return digits() > first ? at : end;
}

double value_of(const std::string& number) {
  const std::size_t power = number.find('^');
  const double base = parse_number(number.substr(0, power)).value_or(0);
  if (power == std::string::npos) return base;
  return std::pow(base, parse_number(number.substr(power + 1)).value_or(0));
}

// Whether a number between these texts is a factor: beside a sign of a product, behind or before
// an x if it is no digit alone, which numbers an axis, or with a power.
bool is_scaling(std::string_view before, const std::string& number, std::string_view after) {
  const auto is_name = [](std::string_view text, std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  const bool has_power = number.find_first_of("e^") != std::string::npos;
  if (has_power && !is_name(before, before.size() - 1)) return true;
  before = trim(before);
  after = trim(after);
  const char last = before.empty() ? ' ' : before.back();
  const char next = after.empty() ? ' ' : after.front();
  if (last == '*' || next == '*') return true;
  if (number.size() < 2) return false;
  if (last == '/') return !is_name(after, 0) && next != '/';
  return (last == 'x' && !is_name(before, before.size() - 2)) ||
         (next == 'x' && !is_name(after, 1));
}

bool begins_with(const std::string& word, std::string_view beginning) {
  return word.rfind(beginning, 0) == 0;
}

// The name of an optional column without its unit: "supply" of "supply_v".
std::string_view base_of(const ColumnInfo& column) {
  return column.name.substr(0, column.name.rfind('_'));
}

}  // namespace

std::optional<double> factor_in(std::string_view name) {
  constexpr std::string_view kTimes = "\xC3\x97";
  std::string text = folded(name);
  for (std::size_t at = text.find(kTimes); at != std::string::npos; at = text.find(kTimes)) {
    text.replace(at, kTimes.size(), "*");
  }
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_numeral(text[at])) continue;
    const std::size_t end = end_of_number(text, at);
    const std::string number = text.substr(at, end - at);
    if (is_scaling(std::string_view(text).substr(0, at), number,
                   std::string_view(text).substr(end))) {
      return value_of(number);
    }
    at = end;
  }
  return std::nullopt;
}

std::string without_quotes(std::string_view name) {
  name = trim(name);
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  return std::string(trim(name));
}

std::string key_of_name(std::string_view name) {
  std::string key = folded(without_quotes(name));
  key.erase(std::remove_if(key.begin(), key.end(), [](char c) { return c == ' ' || c == '\t'; }),
            key.end());
  return key;
}

Quantity quantity_of(std::size_t slot) {
  if (slot == slot_of(Column::rate_dph) || slot == slot_of(Column::input_rate_dph)) {
    return Quantity::rate;
  }
  if (slot >= kColumns.size()) return Quantity::other;
  const std::string_view name = kColumns[slot].name;
  return find_unit(name.substr(name.rfind('_') + 1)).value_or(Unit{Quantity::other}).quantity;
}

ColumnName::ColumnName(std::string_view name, std::string_view from_units_row)
    : text(without_quotes(name)), key(key_of_name(name)) {
  if (is_unit_alone(key) && (unit = find_unit(text))) {
    unit_alone = true;
    unit_text = text;
  } else {
    take_bracket();
    // "coil_degC" before "TimeUS"
    if (!unit && unknown_unit.empty()) take_tail(text);
    if (!unit && unknown_unit.empty()) take_tail(split_camel_case(text));
  }
  if (!unit_alone && unknown_unit.empty()) {
    factor = factor_in(unit ? text.substr(0, text.rfind(unit_text)) : text);
  }
  if (stem_key.empty()) stem_key = key;
  if (words.empty() && !unit_alone) words = words_of(split_camel_case(text));
  std::string row(without_quotes(from_units_row));
  if (row.size() > 2 && (row.front() == '[' || row.front() == '(')) {
    row = row.substr(1, row.size() - 2);
  }
  const auto from_row = find_unit(row);
  if (!from_row) return;
  if (unit && unit->words != from_row->words) {
    contradiction = "'" + displayable(text) + "' is in " + unit->words + " by its name and in " +
                    from_row->words + " by the units beside it";
  }
  unit = from_row;
  unit_text = row;
  unknown_unit.clear();
}

void ColumnName::take_bracket() {
  if (text.size() < 2) return;
  constexpr std::string_view kClosing = ")]}";
  constexpr std::string_view kOpening = "([{";
  const std::size_t kind = kClosing.find(text.back());
  if (kind == std::string_view::npos) return;
  const std::size_t open = text.rfind(kOpening[kind]);
  if (open == std::string::npos) return;
  const std::string inside = text.substr(open + 1, text.size() - open - 2);
  const std::string stem = text.substr(0, open);
  unit = find_multiple(inside);
  (unit ? unit_text : unknown_unit) = inside;
  stem_key = key_of_name(stem);
  words = words_of(split_camel_case(stem));
}

// Takes the longest suffix that is a unit: "deg_s" of "gyro_deg_s".
void ColumnName::take_tail(const std::string& name) {
  constexpr std::string_view kSeparators = "_ ,:;.-/";
  for (std::size_t at = name.find_first_of(kSeparators); at != std::string::npos;
       at = name.find_first_of(kSeparators, at + 1)) {
    const std::string tail(trim(name.substr(at + 1)));
    if (begins_with(folded(tail), "-")) continue;  // it separates the unit from the name
    const auto found = find_unit(tail);
    if (!found) continue;
    if (!factor_in(name.substr(0, at)) && is_factor(name.substr(0, at))) {
      unknown_unit = name.substr(name.find_last_of("_ ,:;(*", at - 1) + 1);
      return;
    }
    unit = found;
    unit_text = tail;
    words = words_of(name.substr(0, at));
    stem_key = key_of_name(name.substr(0, at));
    return;
  }
}

bool ColumnName::has_minus() const {
  const bool is_sign =
      key.size() > 1 && key[0] == '-' && parse_number(key.substr(0, 2)) == std::nullopt;
  const std::string name = folded(text.substr(0, text.find_first_of("[({")));
  for (std::size_t at = 1; at + 1 < name.size(); ++at) {
    const bool begins = name[at] == '-' && (name[at - 1] == ' ' || name[at - 1] == '_');
    if (begins && std::isalpha(static_cast<unsigned char>(name[at + 1])) != 0) return true;
  }
  return is_sign || has_word({"minus", "neg", "invert"});
}

bool ColumnName::has_word(const std::vector<std::string_view>& beginnings) const {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](std::string_view each) { return begins_with(word, each); });
  });
}

// "UTC Year", "UTC Second" are parts of a date, and no time by themselves.
bool ColumnName::is_part_of_date() const {
  constexpr std::string_view kParts[] = {"year",   "month",  "day",         "hour",
                                         "minute", "second", "millisecond", "millesecond"};
  const std::vector<std::string> all = words_of(text.substr(0, text.find_first_of("[(")));
  return all.size() == 2 && (all[0] == "utc" || all[0] == "date" || all[0] == "local") &&
         std::find(std::begin(kParts), std::end(kParts), all[1]) != std::end(kParts);
}

bool ColumnName::is_time() const {
  if (unit && unit->quantity == Quantity::date) return true;
  if (unit && unit->quantity != Quantity::time) return false;
  if (unit_alone) return true;
  if (is_part_of_date()) return false;
  // The time of the week of GPS.
  if (std::find(words.begin(), words.end(), "tow") != words.end()) return true;
  if (words == std::vector<std::string>{"t"}) return unit || text[0] == 't';
  if (has_word({"temp", "sample", "const"})) return false;
  return has_word({"time", "elapsed", "zeit", "uhr", "date", "datum", "epoch", "unix", "utc"}) ||
         (unit && has_word({"stamp", "tv"}));
}

// What was wanted of a sensor, or is known of its readings.
bool ColumnName::is_no_reading() const {
  return has_word({"set", "target", "cmd", "command", "demand", "std", "sigma", "noise", "err",
                   "resid", "limit"});
}

bool ColumnName::is_temperature() const {
  // "T(°)" is asked for its unit.
  const bool in_degrees = unit && folded(unit_text) == "deg";
  if (unit && unit->quantity != Quantity::temperature && !in_degrees) return false;
  if (unit_alone) return is_unambiguous(unit_text);
  if (has_word({"rate", "grad", "deriv", "dt"}) || is_no_reading()) return false;
  if (words == std::vector<std::string>{"t"}) return unit || text[0] == 'T';
  return has_word({"temp"}) || (unit && is_unambiguous(unit_text));
}

bool ColumnName::is_rate() const {
  if (unit && unit->quantity != Quantity::rate && unit->quantity != Quantity::counts) return false;
  if (is_no_reading() || has_word({"temp", "sample", "data", "frame", "input", "ref", "table",
                                   "turntable", "true", "truth", "earth", "bias", "drift"})) {
    return false;
  }
  if (unit && unit->quantity == Quantity::rate) return true;
  return has_word({"rate", "gyr", "omega", "angvel", "drehrate", "angular"}) ||
         (!words.empty() && (words[0] == "wx" || words[0] == "wy" || words[0] == "wz"));
}

// Columns other than time, temperature and rate need their own names and a unit.
std::optional<std::size_t> ColumnName::optional_slot() const {
  if (!unit || unit_alone) return std::nullopt;
  if (unit->quantity == Quantity::rate && has_word({"input", "table", "turntable"})) {
    return slot_of(Column::input_rate_dph);
  }
  const std::string base = join(words, "_");
  for (std::size_t slot = slot_of(Column::uptime_s); slot < kColumns.size(); ++slot) {
    if (base == base_of(kColumns[slot]) && quantity_of(slot) == unit->quantity) return slot;
  }
  return std::nullopt;
}

std::optional<ColumnMeaning> ColumnName::meaning() const {
  if (const auto slot = optional_slot()) return ColumnMeaning{*slot, unit};
  if (is_time()) return ColumnMeaning{slot_of(Column::time_s), unit};
  if (is_temperature()) return ColumnMeaning{slot_of(Column::temperature_degc), unit};
  if (is_rate()) return ColumnMeaning{slot_of(Column::rate_dph), unit};
  return std::nullopt;
}

}  // namespace fogcomp::recording
