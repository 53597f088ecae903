#include "recording/plausibility.hpp"

#include <algorithm>
#include <cmath>

#include "recording/board_limits.hpp"
#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "recording/segments.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kRootHourPerRootSecond = 60;

/// Fastest change of temperature between rows at least `min_s` apart, without a gap between them.
struct TemperatureChange {
  double degc = 0;
  double length_s = 0;
  double degc_per_min() const { return length_s > 0 ? degc / length_s * kSecondsPerMinute : 0; }
};

TemperatureChange fastest_change(const Recording& recording, double window_s) {
  TemperatureChange fastest;
  for (const RowRange& stretch : stretches_of(recording, {0, recording.rows()})) {
    std::size_t begin = stretch.first;
    for (std::size_t row = stretch.first; row < stretch.end; ++row) {
      const auto length_s = [&](std::size_t from) {
        return recording.time_s[row] - recording.time_s[from];
      };
      while (begin + 1 < row && length_s(begin + 1) >= window_s) ++begin;
      if (begin == row || length_s(begin) < window_s) continue;
      const TemperatureChange change{
          std::fabs(recording.temperature_degc[row] - recording.temperature_degc[begin]),
          length_s(begin)};
      if (change.degc_per_min() > fastest.degc_per_min()) fastest = change;
    }
  }
  return fastest;
}

std::string noise_doubt(double white_noise_dph_rthz) {
  const double walk_dprh = white_noise_dph_rthz / kRootHourPerRootSecond;
  if (walk_dprh > 0 && walk_dprh < rules::kMinAngleRandomWalkDprh) {
    return format(
        "noise of %.2g deg/sqrt(h) is less than the light of a fibre gyro allows (%g): "
        "is the rate in deg/h, or in deg/s or rad/s? was it denoised?",
        walk_dprh, rules::kMinAngleRandomWalkDprh);
  }
  if (walk_dprh > rules::kMaxAngleRandomWalkDprh) {
    return format(
        "noise of %.2g deg/sqrt(h) is more than any gyro has (%g): is the rate in deg/h? "
        "is the scale factor right?",
        walk_dprh, rules::kMaxAngleRandomWalkDprh);
  }
  return "";
}

std::string length_doubt(const Recording& recording) {
  const double length_h = (recording.time_s.back() - recording.time_s.front()) / kSecondsPerHour;
  if (length_h <= rules::kMaxRunHours) return "";
  return format("a run of %.0f h: is the time in s, or in ms?", length_h);
}

std::string fast_doubt(const Recording& recording) {
  const double length_s = recording.time_s.back() - recording.time_s.front();
  const TemperatureChange fastest = fastest_change(recording, std::min(kHoldSeconds, length_s));
  if (fastest.degc < rules::kMinDoubtedDegc ||
      fastest.degc_per_min() <= rules::kMaxCoilDegcPerMin) {
    return "";
  }
  return format(
      "the temperature moves by %.3g degC in %.3g s, as no chamber can move a coil: is "
      "the time in s, or in min?",
      fastest.degc, fastest.length_s);
}

std::string slow_doubt(const Recording& recording) {
  const auto [min, max] =
      std::minmax_element(recording.temperature_degc.begin(), recording.temperature_degc.end());
  const double span_degc = *max - *min;
  const TemperatureChange fastest = fastest_change(recording, rules::kSlowWindowS);
  if (span_degc < rules::kMinDoubtedDegc || fastest.degc == 0 ||
      fastest.degc_per_min() >= rules::kMinChamberDegcPerMin) {
    return "";
  }
  return format(
      "the temperature goes through %.3g degC at %.2g degC/h at most, slower than a day "
      "does: is the time in s, or in ms?",
      span_degc, fastest.degc_per_min() * 60);
}

}  // namespace

std::string fault_of_signs(const std::vector<double>& rate_dph, const Unit& unit) {
  std::vector<double> counts;
  for (const double rate : rate_dph) {
    const double count = rate / unit.factor * unit.divisor;
    constexpr double kRounding = 1e-6;
    if (count < 0 || std::fabs(count - std::round(count)) > kRounding) return "";
    counts.push_back(std::round(count));
  }
  std::sort(counts.begin(), counts.end());
  for (const int bits : {16, 24, 32}) {
    const double span = std::ldexp(1.0, bits);
    const auto upper = std::lower_bound(counts.begin(), counts.end(), span / 2);
    if (upper == counts.begin() || upper == counts.end() || counts.back() >= span) continue;
    const double width = (*(upper - 1) - counts.front()) + (counts.back() - *upper);
    const double joined = counts.front() + span - counts.back();
    const bool are_many = upper - counts.begin() >= static_cast<std::ptrdiff_t>(kFewValues) &&
                          counts.end() - upper >= static_cast<std::ptrdiff_t>(kFewValues);
    if (!are_many || counts.back() == *upper || joined > width || width > span / 2) continue;
    return format(
        "its rate is %.0f to %.0f and %.0f to %.0f, as are negative counts that are written "
        "without a sign; subtract %.0f from those of the second range",
        counts.front(), *(upper - 1), *upper, counts.back(), span);
  }
  return "";
}

std::string doubt_of_time(const Recording& recording) {
  for (const std::string& doubt :
       {length_doubt(recording), fast_doubt(recording), slow_doubt(recording)}) {
    if (!doubt.empty()) return doubt;
  }
  return "";
}

std::vector<std::string> doubts(const Recording& recording, double white_noise_dph_rthz) {
  std::vector<std::string> lines;
  for (const std::string& doubt : {noise_doubt(white_noise_dph_rthz), length_doubt(recording),
                                   fast_doubt(recording), slow_doubt(recording)}) {
    if (!doubt.empty()) lines.push_back(recording.file + ": " + doubt);
  }
  return lines;
}

}  // namespace fogcomp::recording
