#pragma once

#include <vector>

namespace fogcomp {

/// Standard score of a chi^2 with `degrees_of_freedom` (Wilson & Hilferty 1931); 0 below one
/// degree.
double standard_score(double chi_square, double degrees_of_freedom);

/// ln of the probability that a standard normal variable exceeds `score`, by its asymptotic tail; 0
/// below 1.
double tail_log_p(double score);

/// Probability that the ratio of two independent estimates of one variance is larger than `ratio`
/// (Fisher's F), 0..1. `above`, `below`: their degrees of freedom, > 0.
double chance_of_variance_ratio(double ratio, double above, double below);

/// Median, the lower one of two; 0 without values. O(n).
double median(std::vector<double> values);

/// Standard deviation about zero of normally distributed values, from the median of their
/// magnitudes: robust against a few outliers.
double sigma_by_median(std::vector<double> values);

}  // namespace fogcomp
