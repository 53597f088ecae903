#include "recording/reading.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recording/board_limits.hpp"
#include "recording/column_map.hpp"
#include "recording/csv_header.hpp"
#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "recording/segments.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"
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

// Its noise lets no rate grow from each sample to the next.
std::string growth_doubt(const std::vector<double>& rate_dph) {
  if (rate_dph.size() < kEnoughValues || rate_dph.front() == rate_dph.back()) return "";
  if (!std::is_sorted(rate_dph.begin(), rate_dph.end()) &&
      !std::is_sorted(rate_dph.rbegin(), rate_dph.rend())) {
    return "";
  }
  return format(
      "the rate never turns back on its way from %.6g to %.6g deg/h: is it an angle that is "
      "counted on? give its change per second",
      rate_dph.front(), rate_dph.back());
}

// By the course of its temperature.
std::string doubt_of_course(const Recording& recording) {
  const auto& degc = recording.temperature_degc;
  const auto [min, max] = std::minmax_element(degc.begin(), degc.end());
  const double span_degc = *max - *min;
  if (span_degc < rules::kMinDoubtedDegc) return "";
  // Of a short run, too: from its coldest to its warmest sample.
  const double span_s = std::fabs(recording.time_s[static_cast<std::size_t>(min - degc.begin())] -
                                  recording.time_s[static_cast<std::size_t>(max - degc.begin())]);
  const TemperatureChange fastest = fastest_change(recording, std::min(kHoldSeconds, span_s));
  if (fastest.degc >= rules::kMinDoubtedDegc &&
      fastest.degc_per_min() > rules::kMaxCoilDegcPerMin) {
    return format(
        "the temperature moves by %.3g degC in %.3g s, as no chamber can move a coil: is "
        "the time in s, or in min or h?",
        fastest.degc, fastest.length_s);
  }
  const TemperatureChange slow = fastest_change(recording, rules::kSlowWindowS);
  if (slow.degc == 0 || slow.degc_per_min() >= rules::kMinChamberDegcPerMin) return "";
  return format(
      "the temperature goes through %.3g degC at %.2g degC/h at most, slower than a day "
      "does: is the time in s, or in ms?",
      span_degc, slow.degc_per_min() * 60);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

bool says_its_sign(const Unit& unit) {
  return unit.quantity == Quantity::counts && unit.words.find("counts") == std::string::npos;
}

// Whether the jumps between neighbours are less the other way round a counter of this span. Those
// of a table may be so by chance, but for a usual width: round it they are not like the others. Few
// values in one half, or one, are disturbances.
bool jump_round(const std::vector<double>& counts, double span, bool is_usual_width) {
  const auto [min, max] = std::minmax_element(counts.begin(), counts.end());
  const double middle = *min < 0 ? 0 : span / 2;
  const auto upper =
      std::count_if(counts.begin(), counts.end(), [&](double count) { return count >= middle; });
  const auto largest = std::count(counts.begin(), counts.end(), *max);
  double jumps = 0;
  double shorter = 0;
  double other = 0;
  std::vector<double> round;
  for (std::size_t row = 1; row < counts.size(); ++row) {
    const double jump = std::fabs(counts[row] - counts[row - 1]);
    jumps += jump * jump;
    shorter += std::pow(std::min(jump, span - jump), 2);
    if (jump <= span / 2) {
      other = std::max(other, jump);
    } else {
      round.push_back(span - jump);
    }
  }
  return upper >= static_cast<std::ptrdiff_t>(kFewValues) && largest < upper &&
         shorter < kMost * jumps && (is_usual_width || kMost * median(std::move(round)) <= other);
}

// The unit by which values of a rate are nearly `ratio` times as large; "" if none does that.
std::string choice_of_unit(const CsvHeader& header, std::size_t slot, double ratio) {
  const Unit now = header.unit_of(slot);
  std::string choice;
  double nearest = kNoticeable;
  for (const std::string& words : units_of(Quantity::rate)) {
    const double is = find_unit(words)->convert(1) / now.factor * now.divisor / ratio;
    if (std::fabs(std::fabs(is) - 1) >= nearest) continue;
    nearest = std::fabs(std::fabs(is) - 1);
    choice = " or '" + map_key(slot) + "=" + column_choice(header.names, header.field_of(slot)) +
             (is < 0 ? "[-" : "[") + words + "]'";
  }
  return choice;
}

}  // namespace

std::string fault_of_signs(const std::vector<double>& rate_dph, const CsvHeader& header) {
  const Unit unit = header.unit_of(kRateSlot);
  const bool are_counts = unit.quantity == Quantity::counts;
  if (says_its_sign(unit) || rate_dph.size() < kFewValues) return "";
  std::vector<double> counts;
  for (const double rate : rate_dph) {
    const double count = std::round(rate / unit.factor * unit.divisor);
    if ((count < 0 && !are_counts) || unit.convert(count) != rate) return "";
    counts.push_back(count);
  }
  const auto [min, max] = std::minmax_element(counts.begin(), counts.end());
  const bool have_sign = *min < 0;
  const double size = have_sign ? 2 * std::max(-*min, *max + 1) : *max + 1;
  const int bits = std::max(kMinConverterBits, static_cast<int>(std::ceil(std::log2(size))));
  if (bits > kMaxConverterBits) return "";
  const double span = std::exp2(bits);
  // No gyro rests at half of what it can measure, and no converter has 32 bits.
  const bool is_usual_width = !have_sign && bits % 8 == 0 && bits >= 16;
  const bool may_rest = !are_counts && bits < 32;
  const bool is_far = is_usual_width && !may_rest && mean(counts) >= kMost * span / 2;
  if (!is_far && !jump_round(counts, span, is_usual_width)) return "";
  const std::string choice = "'rate=" + column_choice(header.names, header.field_of(kRateSlot)) +
                             "[" + unit.words.substr(0, unit.words.find("counts"));
  if (have_sign) {
    return format("its counts jump by nearly %.0f between neighbours, as of %d bits that overflow",
                  span, bits) +
           format("; add or subtract %.0f there, or say that they are right: --columns ", span) +
           choice + format("int%d]'", bits);
  }
  const std::string are = format("%.0f to %.0f, as of %d bits without a sign", *min, *max, bits);
  if (!are_counts) {
    return "its rate is " + are + format("; subtract %.0f from all from %.0f on", span, span / 2);
  }
  return "its counts are " + are + "; say what they are: --columns " + choice +
         format("int%d]' (%.0f is -1), ", bits, span - 1) + choice +
         format("offset%d]' (%.0f is 0) or ", bits, span / 2) + choice +
         format("uint%d]' (all are positive)", bits);
}

std::string fault_of_input_rate(const Recording& recording, const CsvHeader& header) {
  const std::vector<double>& rate = recording.rate_dph;
  const std::vector<double>& input = recording.input_rate_dph;
  if (!header.has(kInputRateSlot) || input.size() < kFewValues) return "";
  const double rate_mean = mean(rate);
  const double input_mean = mean(input);
  double product = 0;
  double square = 0;
  double rate_square = 0;
  for (std::size_t row = 0; row < rate.size(); ++row) {
    product += (rate[row] - rate_mean) * (input[row] - input_mean);
    square += std::pow(input[row] - input_mean, 2);
    rate_square += std::pow(rate[row] - rate_mean, 2);
  }
  if (product * product <= kMost * square * rate_square) return "";
  const double slope = product / square;
  if (std::fabs(slope - 1) <= kMost) return "";
  return format("its rate changes by %.4g where its input rate changes by 1: ", slope) +
         (slope < 0 ? "one of them is late, or " : "one of them ") +
         "has another unit or sign; say which: --columns 'input_rate=" +
         column_choice(header.names, header.field_of(kInputRateSlot)) + "[" +
         header.unit_of(kInputRateSlot).words + "]' if it is right" +
         choice_of_unit(header, kInputRateSlot, slope) +
         choice_of_unit(header, kRateSlot, 1 / slope);
}

std::string doubt_of_time(const Recording& recording) {
  const double length_h = (recording.time_s.back() - recording.time_s.front()) / kSecondsPerHour;
  if (length_h <= rules::kMaxRunHours) return doubt_of_course(recording);
  return format("a run of %.0f h: is the time in s, or in ms?", length_h);
}

std::vector<std::string> doubts(const Recording& recording, double white_noise_dph_rthz) {
  std::vector<std::string> lines;
  for (const std::string& doubt : {noise_doubt(white_noise_dph_rthz),
                                   growth_doubt(recording.rate_dph), doubt_of_time(recording)}) {
    if (!doubt.empty()) lines.push_back(recording.file + ": " + doubt);
  }
  return lines;
}

}  // namespace fogcomp::recording
