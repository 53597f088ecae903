#include "support/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp {
namespace {

// Regularised incomplete beta function by its continued fraction (Abramowitz & Stegun 26.5.8),
// which converges for x < (a + 1) / (a + b + 2).
double incomplete_beta(double x, double a, double b) {
  constexpr int kTerms = 400;
  double fraction = 1;
  for (int i = kTerms; i > 0; --i) {
    const double m = i / 2;
    const double term = i % 2 == 0 ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                                   : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    fraction = 1 + term / fraction;
  }
  const double log = a * std::log(x) + b * std::log1p(-x) + std::lgamma(a + b) - std::lgamma(a) -
                     std::lgamma(b) - std::log(a);
  return std::exp(log) / fraction;
}

}  // namespace

double standard_score(double chi_square, double degrees_of_freedom) {
  if (degrees_of_freedom < 1) return 0;
  const double spread = 2 / (9 * degrees_of_freedom);
  return (std::cbrt(chi_square / degrees_of_freedom) - (1 - spread)) / std::sqrt(spread);
}

double tail_log_p(double score) {
  constexpr double kRootTwoPi = 2.5066;
  return score < 1 ? 0 : -score * score / 2 - std::log(score * kRootTwoPi);
}

double chance_of_variance_ratio(double ratio, double above, double below) {
  const double x = below / (below + above * ratio);
  const double a = below / 2;
  const double b = above / 2;
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  return x < (a + 1) / (a + b + 2) ? incomplete_beta(x, a, b) : 1 - incomplete_beta(1 - x, b, a);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double sigma_by_median(std::vector<double> values) {
  constexpr double kSigmaPerMedian = 1.4826022185056018;  // of |normal|
  for (double& value : values) value = std::abs(value);
  return kSigmaPerMedian * median(std::move(values));
}

}  // namespace fogcomp
