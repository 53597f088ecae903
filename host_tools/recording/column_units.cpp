#include "recording/column_units.hpp"

#include <algorithm>
#include <cctype>

#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

// A unit beside the one that fogcomp reads: ours = (theirs - offset) * factor.
struct ForeignUnit {
  const char* spelling;  // lower case, as the end of a name
  const char* words;
  const char* ours;  // the unit at the end of a column's name
  double factor;
  double offset = 0;
};

constexpr double kDphPerRadianPerSecond = kDphPerDegreePerSecond * 180 / kPi;

const ForeignUnit kForeignUnits[] = {
    {"dps", "deg/s", "dph", kDphPerDegreePerSecond},
    {"degps", "deg/s", "dph", kDphPerDegreePerSecond},
    {"deg/s", "deg/s", "dph", kDphPerDegreePerSecond},
    {"mdps", "mdeg/s", "dph", kDphPerDegreePerSecond / 1000},
    {"dpm", "deg/min", "dph", 60},
    {"deg/min", "deg/min", "dph", 60},
    {"rps", "rad/s", "dph", kDphPerRadianPerSecond},
    {"radps", "rad/s", "dph", kDphPerRadianPerSecond},
    {"rads", "rad/s", "dph", kDphPerRadianPerSecond},
    {"rad/s", "rad/s", "dph", kDphPerRadianPerSecond},
    {"ms", "milliseconds", "s", 1e-3},
    {"us", "microseconds", "s", 1e-6},
    {"ns", "nanoseconds", "s", 1e-9},
    {"min", "minutes", "s", kSecondsPerMinute},
    {"h", "hours", "s", kSecondsPerHour},
    {"k", "kelvin", "degc", 1, 273.15},
    {"kelvin", "kelvin", "degc", 1, 273.15},
    {"f", "Fahrenheit", "degc", 1 / 1.8, 32},
    {"degf", "Fahrenheit", "degc", 1 / 1.8, 32},
    {"mt", "millitesla", "ut", 1e3},
    {"nt", "nanotesla", "ut", 1e-3},
    {"gauss", "gauss", "ut", 100},
    {"mw", "milliwatt", "uw", 1e3},
    {"nw", "nanowatt", "uw", 1e-3},
    {"mv", "millivolt", "v", 1e-3},
};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// "rate_dps", "rate [deg/s]", "rate (dps)": what is measured, and in what.
struct NameParts {
  std::string quantity;
  std::string unit;  // "" where the name has none
};

NameParts parts_of(const std::string& name) {
  std::string text = lower_case(name);
  while (!text.empty() && (text.back() == ']' || text.back() == ')')) text.pop_back();
  const std::size_t end = text.find_last_of("_[( ");
  if (end == std::string::npos) return {text, ""};
  const std::size_t quantity_end = text.find_last_not_of("_[( ", end);
  return {text.substr(0, quantity_end == std::string::npos ? 0 : quantity_end + 1),
          text.substr(end + 1)};
}

const ForeignUnit* foreign_unit(const std::string& name) {
  const std::string unit = parts_of(name).unit;
  const auto* const found =
      std::find_if(std::begin(kForeignUnits), std::end(kForeignUnits),
                   [&](const ForeignUnit& one) { return unit == one.spelling; });
  return found == std::end(kForeignUnits) ? nullptr : &*found;
}

bool holds_any(const std::string& text, const std::vector<std::string>& stems) {
  return std::any_of(stems.begin(), stems.end(),
                     [&](const std::string& stem) { return text.find(stem) != std::string::npos; });
}

// Whether a name's quantity is that of `column`, as people call it.
bool is_of(Column column, const std::string& quantity) {
  switch (column) {
    case Column::time_s:
      return quantity == "t" || holds_any(quantity, {"time", "elapsed"});
    case Column::temperature_degc:
      return quantity == "t" || quantity == "temp" || quantity == "temperature";
    case Column::rate_dph:
      return holds_any(quantity, {"rate", "gyro", "omega"}) && quantity.rfind("input", 0) != 0;
    default:
      return quantity == parts_of(std::string(column_info(column).name)).quantity;
  }
}

std::string conversion(const ForeignUnit& unit, const std::string& name, Column column) {
  const std::string wanted(column_info(column).name);
  std::string text = "'" + displayable(name) + "' is in " + unit.words + ": ";
  if (unit.offset != 0) text += format("subtract %g, ", unit.offset);
  if (unit.factor < 1) {
    text += format("divide by %.10g, ", 1 / unit.factor);
  } else if (unit.factor > 1) {
    text += format("multiply by %.10g, ", unit.factor);
  }
  text += "then name it " + wanted;
  if (column != Column::rate_dph) return text;
  return text + format("; or name it counts and give --scale-factor %.10g",
                       kDphPerDegreePerSecond / unit.factor);
}

}  // namespace

bool has_foreign_unit(const std::string& name) {
  const ForeignUnit* unit = foreign_unit(name);
  if (unit == nullptr) return false;
  return std::any_of(kColumns.begin(), kColumns.end(), [&](const ColumnInfo& info) {
    return parts_of(std::string(info.name)).unit == unit->ours &&
           is_of(info.column, parts_of(name).quantity);
  });
}

std::string how_to_convert(Column column, const std::vector<std::string>& names) {
  const std::string our_unit = parts_of(std::string(column_info(column).name)).unit;
  std::vector<std::string> of_column;
  std::string text;
  for (const std::string& name : names) {
    const NameParts parts = parts_of(name);
    const ForeignUnit* unit = foreign_unit(name);
    const bool converts = unit != nullptr && unit->ours == our_unit;
    if (!is_of(column, parts.quantity) || (!converts && parts.unit != our_unit)) continue;
    of_column.push_back(displayable(name));
    if (converts && text.empty()) text = conversion(*unit, name, column);
  }
  if (of_column.size() < 2) return text;
  const std::string which = "it could be any of " + join(of_column, ", ");
  return which + (text.empty() ? "; name the right one " + std::string(column_info(column).name)
                               : "; " + text);
}

}  // namespace fogcomp::recording
