#include "recording/rate_resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording/decision_rules.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

bool RateResolution::varies() const {
  return range_dph > rules::kRoundings * kEpsilon * std::max(size_dph, 1.0);
}

double RateResolution::rounding_dph() const {
  const double of_digits = step_dph / std::sqrt(12.0);
  return std::max(of_digits, rules::kRoundings * kEpsilon * size_dph);
}

RateResolution rate_resolution(const Recording& recording) {
  RateResolution resolution;
  const std::vector<double>& rate = recording.rate_dph;
  if (rate.empty()) return resolution;
  const auto [min, max] = std::minmax_element(rate.begin(), rate.end());
  resolution.range_dph = *max - *min;
  resolution.size_dph = std::max(std::abs(*min), std::abs(*max));
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t row = 1; row < rate.size(); ++row) {
    const double change = std::abs(rate[row] - rate[row - 1]);
    if (change > 0 && change < step) step = change;
  }
  if (std::isfinite(step)) resolution.step_dph = step;
  return resolution;
}

void require_varying_rate(const Recording& recording) {
  if (recording.rows() < 2 || rate_resolution(recording).varies()) return;
  throw InputError(recording.file,
                   format("the rate does not move: %.10g deg/h in all %zu samples; is "
                          "the gyro on and connected?",
                          recording.rate_dph[0], recording.rows()));
}

}  // namespace fogcomp::recording
