#include "simulation/profile_line.hpp"

#include <algorithm>
#include <cmath>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::simulation {
namespace {

struct Unit {
  std::string name;
  double factor;  ///< to the simulator's unit
};

struct Kind {
  std::string example;
  std::vector<Unit> units;
  double min;  ///< in the simulator's unit
  double max;
  std::string range;
};

const Kind& kind_of(Dimension dimension) {
  static const std::vector<Kind> kinds{
      {"20 degC", {{"degC", 1}, {"C", 1}}, -100, 150, "-100 to 150 degC"},
      {"0.5 degC/min",
       {{"degC/min", 1.0 / 60}, {"C/min", 1.0 / 60}, {"K/min", 1.0 / 60}},
       1e-4 / 60,
       100.0 / 60,
       "0.0001 to 100 degC/min"},
      {"2 h", {{"s", 1}, {"min", 60}, {"h", 3600}}, 1e-3, 3.6e7, "0.001 s to 10000 h"},
      {"2 W", {{"W", 1}}, 0, 100, "0 to 100 W"},
      {"10 deg/s", {{"deg/s", 3600}, {"deg/h", 1}}, -1.8e6, 1.8e6, "-500 to 500 deg/s"},
      {"0.5 g", {{"g", 1}}, 0, 100, "0 to 100 g"},
      {"50 uT", {{"uT", 1}}, -1e5, 1e5, "-100000 to 100000 uT"},
      {"90 deg", {{"deg", 1}}, -360, 360, "-360 to 360 deg"},
  };
  return kinds[static_cast<std::size_t>(dimension)];
}

}  // namespace

ProfileLine::ProfileLine(const std::string& file, std::size_t number, const std::string& text)
    : where_(file + ":" + std::to_string(number)) {
  std::string spaced = text.substr(0, text.find('#'));
  std::replace_if(
      spaced.begin(), spaced.end(), [](char c) { return c == '\t' || c == '\r'; }, ' ');
  for (const std::string& part : split(spaced, ' ')) {
    if (!part.empty()) words_.push_back(part);
  }
}

void ProfileLine::fail(const std::string& what) const {
  throw InputError(where_, what);
}

std::string ProfileLine::word(const std::string& what) {
  if (at_end()) fail("the line ends where " + what + " is expected");
  return words_[next_++];
}

void ProfileLine::expect_word(const std::string& expected) {
  const std::string found = word("'" + expected + "'");
  if (found != expected) fail("'" + found + "' where '" + expected + "' is expected");
}

void ProfileLine::expect_end() {
  if (!at_end()) fail("'" + words_[next_] + "' is too much; one statement a line");
}

double ProfileLine::quantity(Dimension dimension) {
  const Kind& kind = kind_of(dimension);
  const std::string first = word("a quantity such as '" + kind.example + "'");
  const std::size_t digits = std::min(first.find_first_not_of("0123456789+-.eE"), first.size());
  const auto number = parse_number(first.substr(0, digits));
  if (!number) fail("'" + first + "' is not a quantity such as '" + kind.example + "'");
  const std::string unit_name =
      digits < first.size() ? first.substr(digits) : word("the unit of " + first);
  const auto unit = std::find_if(kind.units.begin(), kind.units.end(),
                                 [&](const Unit& u) { return u.name == unit_name; });
  if (unit == kind.units.end()) {
    std::string names;
    for (const Unit& known : kind.units) names += (names.empty() ? "" : ", ") + known.name;
    fail("unit '" + unit_name + "' is not one of " + names);
  }
  const double value = *number * unit->factor;
  if (value < kind.min || value > kind.max) {
    fail(first + " " + unit_name + " is outside " + kind.range);
  }
  return value;
}

int ProfileLine::whole_number(int min, int max) {
  const std::string found = word("a whole number");
  const auto number = parse_number(found);
  if (!number || *number != std::floor(*number) || *number < min || *number > max) {
    fail(format("'%s' is not a whole number from %d to %d", found.c_str(), min, max));
  }
  return static_cast<int>(*number);
}

int ProfileLine::choice(const std::vector<std::string>& allowed) {
  std::string list;
  for (const std::string& option : allowed) list += (list.empty() ? "" : ", ") + option;
  const std::string found = word("one of " + list);
  const auto match = std::find(allowed.begin(), allowed.end(), found);
  if (match == allowed.end()) {
    fail("'" + found + "' is not one of " + list + did_you_mean(found, allowed));
  }
  return static_cast<int>(match - allowed.begin());
}

}  // namespace fogcomp::simulation
