#include "denoise/thresholds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::denoise {
namespace {

double universal(double n) {
  return std::sqrt(2 * std::log(n));
}

double minimax(double n) {
  return n <= 32 ? 0 : 0.3936 + 0.1829 * std::log2(n);
}

std::vector<double> magnitudes_of(fog::Span<const double> values) {
  std::vector<double> magnitudes;
  magnitudes.reserve(values.size);
  for (const double value : values) magnitudes.push_back(std::abs(value));
  return magnitudes;
}

// Whether the signal is strong enough compared with the noise to trust the risk estimate.
bool is_strong(fog::Span<const double> coefficients, double n, double sigma) {
  double squares = 0;
  for (const double c : coefficients) squares += c * c;
  return squares / (n * sigma * sigma) - 1 >= std::pow(std::log2(n), 1.5) / std::sqrt(n);
}

// The magnitude t that minimises Stein's unbiased estimate of the risk of soft thresholding at t
// (MATLAB's thselect "rigrsure", times sigma): with sorted magnitudes m1 <= m2 ... <= mn, the
// minimum of n - 2 k + (m1^2 + ... + mk^2 + (n - k) mk^2) / sigma^2,  k = 1 ... n.
double min_risk(fog::Span<const double> coefficients, double sigma) {
  std::vector<double> magnitudes = magnitudes_of(coefficients);
  std::sort(magnitudes.begin(), magnitudes.end());
  const auto n = static_cast<double>(magnitudes.size());
  double k = 0;
  double squares = 0;
  double best = 0;
  double best_risk = std::numeric_limits<double>::infinity();
  for (const double magnitude : magnitudes) {
    const double square = magnitude * magnitude;
    k += 1;
    squares += square;
    const double risk = n - 2 * k + (squares + (n - k) * square) / (sigma * sigma);
    if (risk < best_risk) {
      best_risk = risk;
      best = magnitude;
    }
  }
  return best;
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

double threshold_of(ThresholdRule rule, fog::Span<const double> coefficients, double sigma) {
  if (sigma == 0) return 0;
  const auto n = static_cast<double>(coefficients.size);
  switch (rule) {
    case ThresholdRule::sqtwolog:
      return sigma * universal(n);
    case ThresholdRule::minimaxi:
      return sigma * minimax(n);
    case ThresholdRule::rigrsure:
      return min_risk(coefficients, sigma);
    case ThresholdRule::heursure:
      break;
  }
  const double max = sigma * universal(n);
  if (!is_strong(coefficients, n, sigma)) return max;
  return std::min(max, min_risk(coefficients, sigma));
}

double noise_of(fog::Span<const double> details) {
  std::vector<double> magnitudes = magnitudes_of(details);
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  const bool odd = magnitudes.size() % 2 == 1;
  const double below = odd ? *middle : *std::max_element(magnitudes.begin(), middle);
  return (below + *middle) / 2 / 0.6745;
}

void shrink(fog::Span<double> coefficients, double threshold, bool hard) {
  if (hard) {
    for (double& c : coefficients) c = std::abs(c) > threshold ? c : 0;
  } else {
    for (double& c : coefficients) c -= std::clamp(c, -threshold, threshold);
  }
}

}  // namespace fogcomp::denoise
