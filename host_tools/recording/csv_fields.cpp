#include "recording/csv_fields.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::size_t kLongestNumber = 60;
// Largest whole part of a time, so that differences do not overflow: nanoseconds since 1970 until
// 2096.
constexpr std::int64_t kMaxWhole = 4'000'000'000'000'000'000;

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// End of the field that begins at `at`: the next separator outside quotes.
std::size_t end_of_field(std::string_view line, std::size_t at, char separator) {
  bool quoted = false;
  for (; at < line.size(); ++at) {
    if (line[at] == '"') quoted = !quoted;
    const bool separates = separator == ' ' ? is_blank(line[at]) : line[at] == separator;
    if (separates && !quoted) break;
  }
  return at;
}

std::string_view bare(std::string_view field) {
  field = trim(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = trim(field.substr(1, field.size() - 2));
  }
  return field;
}

bool is_missing_mark(std::string_view field) {
  constexpr std::array<std::string_view, 8> kWords{"",     "nan",  "na", "n/a",
                                                   "null", "none", "-",  "--"};
  std::string word;
  for (const char c : field) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

/// Reads the parts of a date from left to right.
class DateScanner {
 public:
  explicit DateScanner(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  bool begins_with(char c) const { return !rest_.empty() && rest_.front() == c; }
  bool begins_with_digit() const { return !rest_.empty() && is_digit(rest_.front()); }
  /// Reads a number of `min_digits` to `max_digits`, at most `max`. Returns how many it has, or 0.
  std::size_t digits(std::size_t min_digits, std::size_t max_digits, int max, int& value) {
    std::size_t count = 0;
    for (value = 0; count < max_digits && count < rest_.size() && is_digit(rest_[count]); ++count) {
      value = 10 * value + (rest_[count] - '0');
    }
    rest_.remove_prefix(count);
    return count >= min_digits && value <= max ? count : 0;
  }
  /// With or without a zero before it: "3", "03".
  std::size_t padded(int max, int& value) { return digits(1, 2, max, value); }
  /// Reads "Mar" or "March", in any case.
  bool month_name(int& month) {
    constexpr std::string_view kNames[] = {"january",   "february", "march",    "april",
                                           "may",       "june",     "july",     "august",
                                           "september", "october",  "november", "december"};
    std::string word;
    for (const char c : rest_) {
      if (std::isalpha(static_cast<unsigned char>(c)) == 0) break;
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    const auto found = std::find_if(std::begin(kNames), std::end(kNames), [&](auto name) {
      return word.size() >= 3 && name.substr(0, word.size()) == word;
    });
    if (found == std::end(kNames)) return false;
    month = static_cast<int>(found - std::begin(kNames)) + 1;
    rest_.remove_prefix(word.size());
    return true;
  }
  /// Reads "AM" or "pm", or nothing: 'a', 'p' or 0.
  char half_of_day() {
    const std::size_t at = begins_with(' ') ? 1 : 0;
    if (rest_.size() < at + 2 || std::tolower(static_cast<unsigned char>(rest_[at + 1])) != 'm') {
      return 0;
    }
    const char half = static_cast<char>(std::tolower(static_cast<unsigned char>(rest_[at])));
    if (half != 'a' && half != 'p') return 0;
    rest_.remove_prefix(at + 2);
    return half;
  }
  bool rest_is(std::string_view text) const { return rest_ == text; }
  /// Reads one of the characters.
  bool one_of(std::string_view characters) {
    if (rest_.empty() || characters.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Reads all of the characters that follow, at least one.
  bool some_of(std::string_view characters) {
    const bool any = one_of(characters);
    while (one_of(characters)) {
    }
    return any;
  }
  /// Reads digits after the point.
  double fraction() {
    double value = 0;
    std::string digits = "0.";
    while (!rest_.empty() && is_digit(rest_.front())) {
      digits += rest_.front();
      rest_.remove_prefix(1);
    }
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  }

 private:
  std::string_view rest_;
};

// Days from 1970-01-01 (proleptic Gregorian calendar, years from March on).
std::int64_t days_since_1970(int year, int month, int day) {
  const std::int64_t y = month <= 2 ? year - 1 : year;
  const std::int64_t era = y / 400;
  const std::int64_t year_of_era = y - era * 400;
  const std::int64_t day_of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  const std::int64_t day_of_era =
      year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
  return era * 146097 + day_of_era - 719468;
}

// Day, month and year, in the order in which they stand.
bool scan_date(DateScanner& scan, DayOrder order, std::int64_t& days) {
  constexpr std::string_view kMarks = "-/. ";
  int year = 0;
  int month = 0;
  int day = 0;
  int first = 0;
  bool is_date = false;
  if (scan.month_name(month)) {
    is_date = scan.some_of(" .-/") && scan.padded(31, day) && scan.some_of(" ,-/") &&
              scan.digits(4, 4, 9999, year);
  } else if (const std::size_t count = scan.digits(1, 8, 99'999'999, first); count == 8) {
    year = first / 10'000;
    month = first / 100 % 100;
    day = first % 100;
    is_date = year >= 1970 && year <= 2100 && month <= 12 && day <= 31;
  } else if (count == 4) {
    year = first;
    is_date = scan.one_of("-/.") && (scan.month_name(month) || scan.padded(12, month)) &&
              scan.one_of("-/.") && scan.padded(31, day);
  } else if (count == 1 || count == 2) {
    const bool has_point = scan.begins_with('.');
    const bool is_month_first = !has_point && order == DayOrder::month_first;
    if (!scan.some_of(kMarks)) return false;
    if (scan.month_name(month)) {
      day = first;
    } else {
      const bool is_read = has_point || order != DayOrder::unknown;
      if (!is_read || !scan.padded(31, day)) return false;
      month = first;
      if (!is_month_first) std::swap(day, month);
    }
    is_date = scan.some_of(kMarks) && scan.digits(4, 4, 9999, year) && month <= 12 && day <= 31;
  }
  if (!is_date || month == 0 || day == 0) return false;
  days = days_since_1970(year, month, day);
  return true;
}

// "13:30", "1:30:15.25 PM", "133015": seconds since midnight.
bool scan_time_of_day(DateScanner& scan, TimeReading& reading) {
  int hour = 0;
  int minute = 0;
  int second = 0;
  const std::size_t digits = scan.digits(1, 2, 24, hour);
  if (digits == 0) return false;
  const bool is_compact = digits == 2 && !scan.begins_with(':');
  const auto two_digits = [&](int max, int& value) {
    return is_compact ? scan.digits(2, 2, max, value) : scan.padded(max, value);
  };
  if ((!is_compact && !scan.one_of(":")) || two_digits(59, minute) == 0) return false;
  if (is_compact ? scan.begins_with_digit() : scan.one_of(":")) {
    if (two_digits(60, second) == 0) return false;
    if (scan.one_of(".,:")) reading.fraction = scan.fraction();
  }
  if (const char half = scan.half_of_day(); half != 0) {
    if (hour < 1 || hour > 12) return false;
    hour = hour % 12 + (half == 'p' ? 12 : 0);
  }
  reading.whole = hour * 3600 + minute * 60 + second;
  return true;
}

// "+01:00", "-0530", "Z", "UTC" or nothing: seconds east of Greenwich.
bool scan_zone(DateScanner& scan, std::int64_t& east_s) {
  scan.one_of(" ");
  if (scan.at_end() || scan.rest_is("UTC") || scan.rest_is("GMT")) return true;
  if (scan.one_of("Zz")) return scan.at_end();
  const bool west = scan.one_of("-");
  int hours = 0;
  int minutes = 0;
  if (!west && !scan.one_of("+")) return false;
  if (!scan.digits(2, 2, 14, hours)) return false;
  scan.one_of(":");
  if (!scan.at_end() && !scan.digits(2, 2, 59, minutes)) return false;
  east_s = (west ? -1 : 1) * (hours * 3600 + minutes * 60);
  return scan.at_end();
}

// Behind a date.
bool scan_rest(DateScanner& scan, TimeReading& reading) {
  std::int64_t east_s = 0;
  const bool is_compact = scan.begins_with_digit();
  if (!is_compact && !scan.one_of("Tt") && !scan.some_of(" ,:_")) return false;
  if (!scan_time_of_day(scan, reading) || !scan_zone(scan, east_s)) return false;
  reading.whole -= east_s;
  return true;
}

// "26:30:15.25", of any number of hours: seconds.
std::optional<TimeReading> read_clock(DateScanner& scan) {
  constexpr int kMaxHours = 99'999;  // eleven years
  int hour = 0;
  int minute = 0;
  int second = 0;
  if (scan.digits(1, 5, kMaxHours, hour) == 0 || !scan.one_of(":") ||
      scan.digits(2, 2, 59, minute) == 0 || !scan.one_of(":") ||
      scan.digits(2, 2, 60, second) == 0) {
    return std::nullopt;
  }
  TimeReading reading;
  reading.whole = std::int64_t{hour} * 3600 + minute * 60 + second;
  if (scan.one_of(".,")) reading.fraction = scan.fraction();
  return scan.at_end() ? std::optional(reading) : std::nullopt;
}

// Without the marks of its thousands; "" if they part other digits.
std::string without_groups(std::string_view field, const CsvDialect& dialect, char mark) {
  const std::size_t sign = !field.empty() && (field[0] == '-' || field[0] == '+') ? 1 : 0;
  const std::size_t end = std::min(field.find(dialect.decimal_mark()), field.size());
  if (!is_grouped(field.substr(sign, end - sign), mark)) return "";
  std::string plain(field);
  plain.erase(std::remove(plain.begin(), plain.end(), mark), plain.end());
  return plain;
}

// As other programs and countries write a number that can be no other: "0x3E8", "1.5D+02",
// "1'234.5", with an apostrophe or a blank that breaks no line. "" if it is none.
std::string in_other_spelling(std::string_view field, const CsvDialect& dialect) {
  if (field.substr(0, 2) == "0x" || field.substr(0, 2) == "0X") {
    std::uint64_t number = 0;
    const auto [end, error] =
        std::from_chars(field.data() + 2, field.data() + field.size(), number, 16);
    const bool is_whole = error == std::errc() && end == field.data() + field.size();
    return is_whole ? std::to_string(number) : "";
  }
  std::string plain(field);
  for (const std::string_view mark : {"\xE2\x80\x99", "\xC2\xA0", "\xE2\x80\xAF"}) {
    for (std::size_t at = plain.find(mark); at != std::string::npos; at = plain.find(mark)) {
      plain.replace(at, mark.size(), "'");
    }
  }
  if (plain.find('\'') != std::string::npos) return without_groups(plain, dialect, '\'');
  const std::size_t power = plain.find_first_of("Dd");
  if (power == 0 || power == std::string::npos || plain[power - 1] > '9') return "";
  plain[power] = 'e';
  return plain;
}

}  // namespace

void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  if (separator == ' ') line = trim(line);
  if (line.empty()) return;
  std::size_t at = 0;
  for (;;) {
    const std::size_t end = end_of_field(line, at, separator);
    fields.push_back(bare(line.substr(at, end - at)));
    if (end >= line.size()) return;
    at = end + 1;
    while (separator == ' ' && at < line.size() && is_blank(line[at])) ++at;
  }
}

bool is_grouped(std::string_view digits, char mark) {
  std::size_t at = std::min(digits.find(mark), digits.size());
  if (at == 0 || at > 3 || at == digits.size() || digits[0] == '0') return false;
  if (!std::all_of(digits.begin(), digits.begin() + static_cast<std::ptrdiff_t>(at), is_digit)) {
    return false;
  }
  for (; at < digits.size(); at += 4) {
    const std::string_view group = digits.substr(at + 1, 3);
    if (digits[at] != mark || group.size() != 3) return false;
    if (!std::all_of(group.begin(), group.end(), is_digit)) return false;
  }
  return true;
}

FieldKind read_number(std::string_view field, const CsvDialect& dialect, double& value) {
  constexpr std::string_view kMinus = "\xE2\x88\x92";
  if (field.size() > kLongestNumber) return FieldKind::text;
  if (field.substr(0, kMinus.size()) == kMinus) {
    return read_number("-" + std::string(field.substr(kMinus.size())), dialect, value);
  }
  if (dialect.groups && field.find(dialect.group_mark()) != std::string_view::npos) {
    const std::string plain = without_groups(field, dialect, dialect.group_mark());
    if (plain.empty()) return FieldKind::text;
    return read_number(plain, {dialect.separator, dialect.decimal_comma}, value);
  }
  // With the byte after it that scan_decimal() needs.
  std::array<char, kLongestNumber + 1> text{};
  std::copy(field.begin(), field.end(), text.begin());
  char* const end = text.data() + field.size();
  if (dialect.decimal_comma) {
    if (std::find(text.data(), end, '.') != end) return FieldKind::text;
    std::replace(text.data(), end, ',', '.');
  }
  if (!field.empty() && scan_decimal(text.data(), end, value) == end) return FieldKind::number;
  if (is_missing_mark(field)) return FieldKind::missing;
  const std::string plain = in_other_spelling(field, dialect);
  return plain.empty() ? FieldKind::text : read_number(plain, dialect, value);
}

std::optional<TimeReading> read_long_number(std::string_view field, const CsvDialect& dialect) {
  TimeReading reading;
  if (dialect.groups && field.find(dialect.group_mark()) != std::string_view::npos) {
    return read_long_number(without_groups(field, dialect, dialect.group_mark()),
                            {dialect.separator, dialect.decimal_comma});
  }
  const auto [end, error] =
      std::from_chars(field.data(), field.data() + field.size(), reading.whole);
  const std::string_view rest = field.substr(static_cast<std::size_t>(end - field.data()));
  if (reading.whole > kMaxWhole || reading.whole < -kMaxWhole) return std::nullopt;
  const bool point = !rest.empty() && rest[0] == dialect.decimal_mark();
  const bool digits = rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (error == std::errc() && rest.empty()) return reading;
  if (error == std::errc() && point && digits && rest.size() < kLongestNumber) {
    const std::string fraction = "0." + std::string(rest.substr(1)) + "0";
    std::from_chars(fraction.data(), fraction.data() + fraction.size(), reading.fraction);
    if (field[0] == '-') reading.fraction = -reading.fraction;
    return reading;
  }
  // "1.7e9", "+3"
  double value = 0;
  if (read_number(field, dialect, value) != FieldKind::number) return std::nullopt;
  if (std::fabs(value) > static_cast<double>(kMaxWhole)) return std::nullopt;
  reading.whole = static_cast<std::int64_t>(value);
  reading.fraction = value - static_cast<double>(reading.whole);
  return reading;
}

std::optional<TimeReading> read_calendar_time(std::string_view field, DayOrder order) {
  DateScanner scan(field);
  if (order == DayOrder::no_date) return read_clock(scan);
  std::int64_t days = 0;
  TimeReading reading;
  if (!scan_date(scan, order, days) || !scan_rest(scan, reading)) return std::nullopt;
  reading.whole += days * 86400;
  return reading;
}

CalendarPart calendar_part(std::string_view field) {
  TimeReading reading;
  std::int64_t number = 0;  // of days, or of seconds
  for (const DayOrder order : {DayOrder::day_first, DayOrder::month_first}) {
    DateScanner scan(field);
    if (!scan_date(scan, order, number)) continue;
    if (scan.at_end()) return CalendarPart::date;
    if (scan_rest(scan, reading)) return CalendarPart::both;
  }
  DateScanner scan(field);
  const bool is_time = scan_time_of_day(scan, reading) && scan_zone(scan, number);
  return is_time ? CalendarPart::time_of_day : CalendarPart::none;
}

}  // namespace fogcomp::recording
