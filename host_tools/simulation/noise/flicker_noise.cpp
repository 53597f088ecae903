#include <algorithm>
#include <cmath>

#include "simulation/noise/noise_source.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kSpacing = 2;
// Below this ratio of period to time constant, differences of exponentials lose all digits, and the
// first terms of their series are exact to 1e-4.
constexpr double kSeriesBelow = 1e-4;

}  // namespace

// For a Gauss-Markov process of variance s^2 and time constant tau, with a = period / tau, e =
// exp(-a), the contribution of one period's noise, starting from zero, has
//   Var(end) = s^2 (1 - e^2)      Cov(mean, end) = s^2 (1 - e)^2 / a
//   Var(mean) = s^2 (2a - 3 + 4e - e^2) / a^2
// Equal variances at time constants with ratio q sum to S(f) = s^2 / (2 f ln q), hence s^2 = B^2 ln
// q / pi.
FlickerNoise::FlickerNoise(double b_dph, double period_s, std::uint64_t seed)
    : random_(seed, "flicker") {
  const double variance = b_dph * b_dph * std::log(kSpacing) / M_PI;
  for (double tau_s = kShortest_s; tau_s <= kLongest_s; tau_s *= kSpacing) {
    const double a = period_s / tau_s;
    const double e = std::exp(-a);
    const double end_variance = -variance * std::expm1(-2 * a);
    const double lost = -std::expm1(-a);
    const double covariance = variance * lost * lost / a;
    const double left_variance = a < kSeriesBelow
                                     ? variance * a / 6
                                     : variance * (2 * a - 3 + 4 * e - e * e) / (a * a) -
                                           covariance * covariance / end_variance;
    Process process{};
    process.value_dph = std::sqrt(variance) * random_.gaussian();
    process.memory = e;
    process.end_sigma_dph = std::sqrt(end_variance);
    process.mean_memory = lost / a;
    process.mean_per_end = covariance / process.end_sigma_dph;
    process.mean_sigma_dph = std::sqrt(std::max(left_variance, 0.0));
    processes_.push_back(process);
  }
}

void FlickerNoise::fill(double* values, std::size_t rows) {
  std::fill(values, values + rows, 0.0);
  for (std::size_t row = 0; row < rows; ++row) {
    double sum_dph = 0;
    for (Process& p : processes_) {
      const double end = random_.gaussian();
      sum_dph += p.mean_memory * p.value_dph + p.mean_per_end * end +
                 p.mean_sigma_dph * random_.gaussian();
      p.value_dph = p.memory * p.value_dph + p.end_sigma_dph * end;
    }
    values[row] = sum_dph;
  }
}

}  // namespace fogcomp::simulation
