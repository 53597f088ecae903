#pragma once

#include <vector>

namespace fogcomp {

/// Median, the lower one of two; 0 without values. O(n).
double median(std::vector<double> values);

/// Standard deviation about zero of normally distributed values, from the median of their
/// magnitudes: robust against a few outliers.
double sigma_by_median(std::vector<double> values);

}  // namespace fogcomp
