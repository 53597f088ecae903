#include "denoise/thresholds.hpp"

#include <algorithm>
#include <cmath>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

double universal(double n) {
  return std::sqrt(2 * std::log(n));
}

double minimax(double n) {
  return n <= 32 ? 0 : 0.3936 + 0.1829 * std::log2(n);
}

// Whether the signal stands out of the noise far enough for the risk estimate to be trusted.
bool is_strong(const Magnitudes& magnitudes, double n, double sigma) {
  const double excess = magnitudes.sum_of_squares() / (n * sigma * sigma) - 1;
  return excess >= std::pow(std::log2(n), 1.5) / std::sqrt(n);
}

}  // namespace

const std::vector<std::string>& threshold_rule_names() {
  static const std::vector<std::string> names{"heursure", "sqtwolog", "rigrsure", "minimaxi"};
  return names;
}

ThresholdRule threshold_rule(const std::string& name) {
  const std::vector<std::string>& names = threshold_rule_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError("threshold rule '" + name + "'", "is unknown" + did_you_mean(name, names));
  }
  return static_cast<ThresholdRule>(found - names.begin());
}

double threshold_of(ThresholdRule rule, const Magnitudes& magnitudes, std::size_t n, double sigma) {
  if (sigma == 0) return 0;
  const auto count = static_cast<double>(n);
  switch (rule) {
    case ThresholdRule::sqtwolog:
      return sigma * universal(count);
    case ThresholdRule::minimaxi:
      return sigma * minimax(count);
    case ThresholdRule::rigrsure:
      return magnitudes.least_risk(sigma);
    case ThresholdRule::heursure:
      break;
  }
  const double most = sigma * universal(count);
  return is_strong(magnitudes, count, sigma) ? std::min(most, magnitudes.least_risk(sigma)) : most;
}

double noise_of(const Magnitudes& details) {
  return details.median() / 0.6745;
}

void shrink(fog::Span<double> coefficients, double threshold, bool hard) {
  if (hard) {
    for (double& c : coefficients) c = std::abs(c) > threshold ? c : 0;
  } else {
    for (double& c : coefficients) c -= std::clamp(c, -threshold, threshold);
  }
}

}  // namespace fogcomp
