#include "recording/unit_spelling.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kDphPerRadianPerSecond = kDphPerDegreePerSecond * 180 / kPi;
constexpr double kDphPerTurnPerMinute = kDphPerDegreePerSecond * 6;

struct Spellings {
  Unit unit;
  const char* all;  // as made by key_of(), separated by blanks
};

// "rps" is excluded: revolutions or radians.
const Spellings kSpellings[] = {
    {{Quantity::rate, "deg/h"},
     "dph deg/h deg/hr deg/hour degph degs/h degree/hour degrees/hour degrees/h degree/h"},
    {{Quantity::rate, "deg/s", kDphPerDegreePerSecond},
     "dps degps deg/s deg/sec deg/second degs/s degs/sec degree/s degree/second degrees/s "
     "degrees/second"},
    {{Quantity::rate, "mdeg/s", kDphPerDegreePerSecond, 1000}, "mdps mdeg/s mdeg/sec"},
    {{Quantity::rate, "deg/min", 60}, "dpm deg/min deg/minute degrees/minute"},
    {{Quantity::rate, "rad/s", kDphPerRadianPerSecond},
     "radps rads rad/s rad/sec rad/second rads/s radian/s radians/s radian/second radians/second"},
    {{Quantity::rate, "mrad/s", kDphPerRadianPerSecond, 1e3}, "mrad/s mradps mrad/sec"},
    {{Quantity::rate, "urad/s", kDphPerRadianPerSecond, 1e6}, "urad/s uradps urad/sec"},
    {{Quantity::rate, "nrad/s", kDphPerRadianPerSecond, 1e9}, "nrad/s nradps nrad/sec"},
    {{Quantity::rate, "rad/h", kDphPerRadianPerSecond, kSecondsPerHour}, "rad/h rad/hr rad/hour"},
    {{Quantity::rate, "arcsec/s"}, "arcsec/s arcsec/sec asec/s"},
    {{Quantity::rate, "turns/min", kDphPerTurnPerMinute}, "rpm rev/min turns/min"},
    {{Quantity::time, "s"}, "s sec secs second seconds sekunden"},
    {{Quantity::time, "ms", 1, 1e3}, "ms msec msecs millis millisecond milliseconds"},
    {{Quantity::time, "us", 1, 1e6},
     "us usec usecs micros microsec microsecs microsecond microseconds"},
    {{Quantity::time, "100 ns", 1, 1e7}, "100ns filetime"},
    {{Quantity::time, "ns", 1, 1e9}, "ns nsec nsecs nanos nanosec nanosecs nanosecond nanoseconds"},
    {{Quantity::time, "samples"}, "samples"},
    {{Quantity::time, "min", kSecondsPerMinute}, "min mins minute minutes"},
    {{Quantity::time, "h", kSecondsPerHour}, "h hr hrs hour hours stunden"},
    {{Quantity::time, "days", 24 * kSecondsPerHour}, "d day days"},
    {{Quantity::time, "weeks", 7 * 24 * kSecondsPerHour}, "week weeks"},
    {{Quantity::temperature, "degC"},
     "degc c celsius centigrade degcelsius degreec degreesc degreecelsius degreescelsius"},
    {{Quantity::temperature, "K", 1, 1, 273.15}, "k kelvin kelvins degk degkelvin degreeskelvin"},
    {{Quantity::temperature, "degF", 1, 1.8, 32},
     "f degf fahrenheit degfahrenheit degreef degreesf degreefahrenheit degreesfahrenheit"},
    {{Quantity::temperature, "degR", 1, 1.8, 491.67}, "degr rankine degrankine degreesrankine"},
    {{Quantity::temperature, "mdegC", 1, 1e3}, "mdegc mc"},
    {{Quantity::temperature, "cdegC", 1, 100}, "cdegc"},
    {{Quantity::field, "uT"}, "ut microtesla"},
    {{Quantity::field, "mT", 1e3}, "mt millitesla"},
    {{Quantity::field, "nT", 1, 1e3}, "nt nanotesla"},
    {{Quantity::field, "gauss", 100}, "gauss"},
    {{Quantity::field, "mgauss", 1, 10}, "mgauss milligauss"},
    {{Quantity::power, "uW"}, "uw microwatt"},
    {{Quantity::power, "mW", 1e3}, "mw milliwatt"},
    {{Quantity::power, "nW", 1, 1e3}, "nw nanowatt"},
    {{Quantity::voltage, "V"}, "v volt volts"},
    {{Quantity::voltage, "mV", 1, 1e3}, "mv millivolt millivolts"},
    {{Quantity::vibration, "g rms"}, "grms g/rms"},
    {{Quantity::counts, "counts"}, "count counts lsb raw adc digits"},
    {{Quantity::date, "D/M/Y"}, "d/m/y dd/mm/yyyy ddmmyyyy"},
    {{Quantity::date, "M/D/Y"}, "m/d/y mm/dd/yyyy mmddyyyy"},
    {{Quantity::other, "another unit"},
     "hz khz mhz deg degree degrees rad mrad m mm m/s m/s2 m/s/s g mg pct % a ma ua pa hpa kpa bar "
     "mbar degc/min degc/s "
     "k/min k/s dps/s deg/s2 rad/s2 g/rms/hz w dbm ohm kohm"},
};

const std::map<std::string, Unit>& units_by_key() {
  static const std::map<std::string, Unit> units = [] {
    std::map<std::string, Unit> by_key;
    for (const Spellings& spellings : kSpellings) {
      for (const std::string& key : split(spellings.all, ' ')) by_key.emplace(key, spellings.unit);
    }
    return by_key;
  }();
  return units;
}

// Of a converter of so many bits: "int12" has a sign, "offset12" is 0 in its middle, "uint12" is as
// written.
std::optional<Unit> converter_unit(const std::string& key) {
  const std::size_t digits = key.find_first_of("0123456789");
  const auto bits = digits < key.size() ? parse_number(key.substr(digits)) : std::nullopt;
  if (!bits || *bits < kMinConverterBits || *bits > kMaxConverterBits) return std::nullopt;
  const double span = std::exp2(std::floor(*bits));
  const std::string kind = key.substr(0, digits);
  if (kind == "int") return Unit{Quantity::counts, key, 1, 1, 0, span};
  if (kind == "offset") return Unit{Quantity::counts, key, 1, 1, span / 2};
  return kind == "uint" ? std::optional(Unit{Quantity::counts, key}) : std::nullopt;
}

struct Replacement {
  std::string_view from;
  std::string_view to;
};

std::string replaced(std::string text, const Replacement& each) {
  for (std::size_t at = text.find(each.from); at != std::string::npos; at = text.find(each.from)) {
    text.replace(at, each.from.size(), each.to);
  }
  return text;
}

// Normalises spellings: "deg s^-1", "degrees per second", "deg_s" become equal.
std::string key_of(std::string_view spelling) {
  std::string key;
  for (const char c : folded(spelling)) {
    if (c != ' ' && c != '^' && c != '*' && c != '.' && c != '\t') key += c;
  }
  key = replaced(replaced(key, {"_per_", "/"}), {"per", "/"});
  std::replace(key.begin(), key.end(), '_', '/');
  constexpr std::string_view kInverse = "-1";
  const std::size_t stem = key.size() < 3 ? 0 : key.size() - 3;
  if (stem > 0 && std::string_view(key).substr(stem + 1) == kInverse) {
    key = key.substr(0, stem) + (key[stem - 1] == '/' ? "" : "/") + key[stem];
  }
  return key;
}

}  // namespace

std::string folded(std::string_view text) {
  constexpr Replacement kSigns[] = {{"\xC2\xB0", "deg"},
                                    {"\xC2\xBA", "deg"},
                                    {"\xE2\x84\x83", "degc"},
                                    {"\xC2\xB5", "u"},
                                    {"\xCE\xBC", "u"},
                                    {"\xC2\xB7", ""},
                                    {"\xE2\x8B\x85", ""},
                                    {"\xE2\x81\xBB", "-"},
                                    {"\xE2\x88\x92", "-"},
                                    {"\xC2\xB9", "1"},
                                    {"\xC2\xB2", "2"},
                                    {"\"", ""},
                                    // The same in Latin-1, as single bytes.
                                    {"\xB0", "deg"},
                                    {"\xB5", "u"}};
  std::string result(trim(text));
  for (const Replacement& sign : kSigns) result = replaced(result, sign);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::string(trim(result));
}

std::string Unit::conversion_words() const {
  std::string text;
  if (span != 0) text += format(", of which those from %.0f on less %.0f,", span / 2, span);
  if (offset != 0) text += format(" - %.10g", offset);
  if (offset != 0 && (factor != 1 || divisor != 1)) text += ", then";
  if (factor != 1) text += format(" x %.10g", factor);
  if (divisor != 1) text += format(" / %.10g", divisor);
  return text;
}

std::optional<Unit> find_unit(std::string_view spelling) {
  constexpr std::size_t kLongestSpelling = 40;
  if (spelling.size() > kLongestSpelling) return std::nullopt;
  const std::string key = key_of(spelling);
  // A dash before a blank separates.
  const bool is_negative = key.size() > 1 && key[0] == '-' && folded(spelling)[1] == key[1];
  const std::string name = is_negative ? key.substr(1) : key;
  const auto found = units_by_key().find(name);
  std::optional<Unit> unit =
      found == units_by_key().end() ? converter_unit(name) : std::optional(found->second);
  if (!unit || !is_negative) return unit;
  if (unit->quantity != Quantity::rate && unit->quantity != Quantity::counts) return std::nullopt;
  unit->words = "-" + unit->words;
  unit->factor = -unit->factor;
  return unit;
}

std::optional<Unit> find_multiple(std::string_view spelling) {
  if (const auto unit = find_unit(spelling)) return unit;
  const std::string text = folded(spelling);
  const std::size_t end = std::min(text.find(' '), text.size());
  const auto number = parse_number(text.substr(0, end));
  if (!number || *number <= 0) return std::nullopt;
  auto unit = find_unit(std::string_view(text).substr(end));
  if (!unit || unit->quantity >= Quantity::date) return std::nullopt;
  unit->words = text.substr(0, end) + " " + unit->words;
  unit->offset /= *number;
  // So that 0.1 is exact.
  (*number < 1 ? unit->divisor : unit->factor) *= *number < 1 ? 1 / *number : *number;
  return unit;
}

std::vector<std::string> units_of(Quantity quantity) {
  std::vector<std::string> units;
  for (const Spellings& spellings : kSpellings) {
    if (spellings.unit.quantity == quantity) units.push_back(spellings.unit.words);
  }
  return units;
}

bool is_unambiguous(std::string_view spelling) {
  constexpr std::size_t kFewestLetters = 3;
  return key_of(spelling).size() >= kFewestLetters;
}

}  // namespace fogcomp::recording
