#include "denoise/thresholds.hpp"

#include <Eigen/Core>
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
  const Eigen::Map<const Eigen::VectorXd> all(coefficients.data,
                                              static_cast<Eigen::Index>(coefficients.size));
  return all.squaredNorm() / (n * sigma * sigma) - 1 >= std::pow(std::log2(n), 1.5) / std::sqrt(n);
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

struct Magnitudes {
  std::vector<double> values;
  std::size_t smaller = 0;  // how many others are smaller than these
};

// The magnitudes about the median of all, between two quantiles of a sample. All of them where
// there are few, or where the median does not lie there.
Magnitudes around_median(fog::Span<const double> values) {
  constexpr std::size_t kSample = 4096;
  if (values.size < 8 * kSample) return {magnitudes_of(values)};
  std::vector<double> sample;
  for (std::size_t i = 0; i < kSample; ++i) {
    sample.push_back(std::abs(values[i * (values.size / kSample)]));
  }
  std::sort(sample.begin(), sample.end());
  const double least = sample[kSample / 2 - kSample / 16];
  const double most = sample[kSample / 2 + kSample / 16];
  Magnitudes near;
  for (const double value : values) {
    const double magnitude = std::abs(value);
    near.smaller += magnitude < least ? 1 : 0;
    if (magnitude >= least && magnitude <= most) near.values.push_back(magnitude);
  }
  const bool has_median =
      near.smaller <= (values.size - 1) / 2 && values.size / 2 < near.smaller + near.values.size();
  return has_median ? near : Magnitudes{magnitudes_of(values)};
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
  auto [magnitudes, smaller] = around_median(details);
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(details.size / 2 - smaller);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  const bool odd = details.size % 2 == 1;
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
