#include "recording/csv_layout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "support/statistics.hpp"
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

// Of "123059.5", hours, minutes and seconds.
constexpr double kClockMinute = 100;
constexpr double kClockHour = 100 * kClockMinute;

double clock_s(double number) {
  const double hours = std::floor(number / kClockHour);
  const double minutes = std::floor(std::fmod(number, kClockHour) / kClockMinute);
  return hours * kSecondsPerHour + minutes * kSecondsPerMinute + std::fmod(number, kClockMinute);
}

bool is_clock_reading(double number) {
  return number >= 0 && number < 24 * kClockHour &&
         std::fmod(number, kClockHour) < 60 * kClockMinute && std::fmod(number, kClockMinute) < 60;
}

}  // namespace

bool is_since_power_on(double number, const Unit& unit) {
  return unit.convert(number) < rules::kMaxRunHours * kSecondsPerHour;
}

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
    const bool is_possible = as_date ? scale != nullptr : is_since_power_on(times.first, unit);
    if (is_possible && gives_usual_period(times, unit)) meanings.push_back({unit, scale});
  };
  consider("s", false);
  const bool counts_by_more = times.median_spacing > 1;
  if (!meanings.empty() && counts_by_more && may_be_milliseconds(times)) consider("ms", false);
  for (const char* unit : {"s", "ms", "us", "ns", "100ns"}) consider(unit, true);
  if (times.mean_spacing > 0) consider("days", true);
  if (!meanings.empty()) return meanings;
  for (const char* unit : {"ms", "us", "ns"}) consider(unit, false);
  const Unit seconds = *find_unit("s");
  const bool is_date =
      times.first < rules::kMaxUnixTimeS && !is_since_power_on(times.first, seconds);
  if (is_date && gives_usual_period(times, seconds)) meanings.push_back({seconds});
  return meanings;
}

bool may_be_milliseconds(const TimesSeen& times) {
  return times.are_whole && times.mean_spacing > 0 && gives_usual_period(times, *find_unit("ms"));
}

bool are_of_clock(const std::vector<double>& times) {
  if (!std::all_of(times.begin(), times.end(), is_clock_reading)) return false;
  std::vector<double> spacings;
  std::vector<double> of_clock;
  for (std::size_t i = 1; i < times.size(); ++i) {
    spacings.push_back(times[i] - times[i - 1]);
    of_clock.push_back(clock_s(times[i]) - clock_s(times[i - 1]));
  }
  if (spacings.empty()) return false;
  const double usual = median(spacings);
  const auto gaps_in = [&](const std::vector<double>& all) {
    return std::count_if(all.begin(), all.end(), [&](double each) { return is_gap(each, usual); });
  };
  return 2 * gaps_in(of_clock) < gaps_in(spacings);
}

std::string meaning_words(const TimeMeaning& meaning, const TimesSeen& times) {
  const std::string scale = meaning.scale != nullptr ? format(" (%s dates)", meaning.scale->name)
                            : is_since_power_on(times.first, meaning.unit) ? " since power-on"
                                                                           : " (dates)";
  return meaning.unit.words + scale +
         format(", a sample each %.4g s", meaning.unit.convert(times.mean_spacing));
}

}  // namespace fogcomp::recording
