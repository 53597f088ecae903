#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/signal/span.hpp"

namespace fogcomp::denoise {

/// Rule for the threshold of n coefficients with noise of standard deviation 1, n being the
/// coefficients of the level; definitions of MATLAB's thselect.
enum class ThresholdRule : std::uint8_t {
  heursure,  ///< sqtwolog where the signal is weak: (mean square - 1) < log2(n)^1.5 / sqrt(n); else
             ///< the smaller of sqtwolog and rigrsure. (Donoho & Johnstone 1995, "hybrid".)
  sqtwolog,  ///< sqrt(2 ln n): universal, the largest of n noise values lies about there
  rigrsure,  ///< minimises Stein's unbiased estimate of the risk
  minimaxi,  ///< 0.3936 + 0.1829 log2(n), 0 up to n = 32: minimax risk, approximated
};

const std::vector<std::string>& threshold_rule_names();
/// Throws InputError for an unknown name.
ThresholdRule threshold_rule(const std::string& name);

/// The threshold for these coefficients (at least one) with noise `sigma` (same unit). 0 for
/// sigma = 0.
double threshold_of(ThresholdRule rule, fog::Span<const double> coefficients, double sigma);

/// Standard deviation of noise from the median absolute value of detail coefficients: median /
/// 0.6745. Robust against a signal in less than half of them.
double noise_of(fog::Span<const double> details);

/// Moves coefficients towards 0 by `threshold` (soft), or sets those below it to 0 (hard).
void shrink(fog::Span<double> coefficients, double threshold, bool hard);

}  // namespace fogcomp::denoise
