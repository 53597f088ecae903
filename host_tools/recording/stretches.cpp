#include "recording/reading.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "support/input_error.hpp"
#include "support/median.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

// Removes rounding errors of differences of printed times: 0.00499999999738 becomes 0.005.
double without_rounding_error(double period_s) {
  constexpr double kDigits = 9;
  const double units_per_s = std::pow(10, kDigits - std::floor(std::log10(period_s)));
  return std::round(period_s * units_per_s) / units_per_s;
}

}  // namespace

double median_spacing_s(const std::vector<double>& time_s) {
  constexpr std::size_t kMaxSpacings = 65536;
  constexpr std::size_t kScatter = 7919;  // a prime: spacings may have a rhythm, of packets
  const std::size_t step = time_s.size() / kMaxSpacings + 1;
  std::vector<double> spacings;
  for (std::size_t i = 1; i + step <= time_s.size(); i += step) {
    const std::size_t row = i + i * kScatter % step;
    spacings.push_back(time_s[row] - time_s[row - 1]);
  }
  // Of a clock that jitters while samples are lost, most spacings are long.
  double period_s = median(spacings);
  constexpr int kPeriodRounds = 5;  // until the counts of samples stay
  for (int round = 0; round < kPeriodRounds && period_s > 0; ++round) {
    double samples = 0;
    double sum_s = 0;
    for (const double each_s : spacings) {
      if (each_s > rules::kMaxDropoutS) continue;
      samples += std::round(each_s / period_s);
      sum_s += each_s;
    }
    if (samples > 0) period_s = sum_s / samples;
  }
  return period_s;
}

void find_stretches(Recording& recording) {
  recording.stretch_starts = {0};
  recording.period_s = 0;
  const std::vector<double>& time_s = recording.time_s;
  if (time_s.size() < 2) return;
  const double typical_s = median_spacing_s(time_s);
  double spanned_s = 0;
  std::size_t spacings = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double spacing_s = time_s[i] - time_s[i - 1];
    if (is_gap(spacing_s, typical_s) || recording.restarts_at(i)) {
      recording.stretch_starts.push_back(i);
    } else {
      spanned_s += spacing_s;
      ++spacings;
    }
  }
  const double period_s = spanned_s / static_cast<double>(spacings);
  if (period_s < rules::kMinPeriodS || period_s > rules::kMaxPeriodS) {
    throw InputError(
        recording.file,
        format("samples are %g s apart; is the time in s? if not, give --columns time=NAME[us]",
               period_s));
  }
  recording.period_s = without_rounding_error(period_s);
}

void become_table(Recording& recording) {
  const double end_s = recording.time_s.back() + kDwellSpacingS;
  for (double& time_s : recording.time_s) time_s -= end_s;
  recording.is_table = true;
  recording.period_s = 0;
  recording.stretch_starts.resize(recording.rows());
  std::iota(recording.stretch_starts.begin(), recording.stretch_starts.end(), 0);
}

}  // namespace fogcomp::recording
