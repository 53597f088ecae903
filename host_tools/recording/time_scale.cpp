#include "recording/time_scale.hpp"

#include <algorithm>
#include <iterator>

#include "recording/decision_rules.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kSecondsPerDay = 24 * kSecondsPerHour;

// Their dates do not overlap as numbers, but for those in days, which are one unit.
constexpr TimeScale kScales[] = {
    {"UNIX", "s", 0},
    {"UNIX", "ms", 0},
    {"UNIX", "us", 0},
    {"UNIX", "ns", 0},
    {"FILETIME", "100 ns", -134774 * kSecondsPerDay},      // 1601-01-01
    {".NET", "100 ns", -719162 * kSecondsPerDay},          // 0001-01-01
    {"spreadsheet", "days", -25569 * kSecondsPerDay},      // 1899-12-30
    {"modified Julian", "days", -40587 * kSecondsPerDay},  // 1858-11-17
    {"MATLAB", "days", -719529 * kSecondsPerDay},          // 0000-01-00
    {"Julian", "days", -2440587.5 * kSecondsPerDay},       // -4713-11-24, noon
};

bool is_date(double number, const Unit& unit, const TimeScale& scale) {
  const double unix_s = unit.convert(number) + scale.zero_s;
  return unix_s >= rules::kMinUnixTimeS && unix_s < rules::kMaxUnixTimeS;
}

bool is_usual(double spacing, const Unit& unit) {
  const double period_s = unit.convert(spacing);
  return period_s >= rules::kMinUsualPeriodS && period_s <= rules::kMaxUsualPeriodS;
}

bool gives_usual_period(const TimesSeen& times, const Unit& unit) {
  return times.mean_spacing == 0 || is_usual(times.mean_spacing, unit) ||
         is_usual(times.median_spacing, unit);
}

}  // namespace

const TimeScale* scale_of(double number, const Unit& unit) {
  const auto found = std::find_if(std::begin(kScales), std::end(kScales), [&](const auto& scale) {
    return unit.words == scale.unit && is_date(number, unit, scale);
  });
  return found == std::end(kScales) ? nullptr : found;
}

std::vector<TimeMeaning> possible_meanings(const TimesSeen& times) {
  std::vector<TimeMeaning> meanings;
  const auto consider = [&](const char* spelling, bool as_date) {
    const Unit unit = *find_unit(spelling);
    const TimeScale* scale = as_date ? scale_of(times.first, unit) : nullptr;
    const bool is_possible =
        as_date ? scale != nullptr : unit.convert(times.first) < rules::kMinUnixTimeS;
    if (is_possible && gives_usual_period(times, unit)) meanings.push_back({unit, scale});
  };
  consider("s", false);
  for (const char* unit : {"s", "ms", "us", "ns", "100ns"}) consider(unit, true);
  if (times.mean_spacing > 0) consider("days", true);
  if (!meanings.empty()) return meanings;
  for (const char* unit : {"ms", "us", "ns"}) consider(unit, false);
  return meanings;
}

std::string meaning_words(const TimeMeaning& meaning, const TimesSeen& times) {
  const std::string scale =
      meaning.scale == nullptr ? " since power-on" : format(" (%s dates)", meaning.scale->name);
  return meaning.unit.words + scale +
         format(", a sample each %.4g s", meaning.unit.convert(times.mean_spacing));
}

}  // namespace fogcomp::recording
