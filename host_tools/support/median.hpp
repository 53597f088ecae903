#pragma once

#include <vector>

namespace fogcomp {

/// The lower middle value; 0 of nothing. O(n).
double median(std::vector<double> values);

/// Standard deviation about zero of normally distributed values, from the median of their
/// magnitudes: what a few outliers cannot move.
double sigma_by_median(std::vector<double> values);

}  // namespace fogcomp
