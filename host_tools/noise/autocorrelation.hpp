#pragma once

#include <cstddef>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::noise {

/// Correlation of `values` (overall mean removed) with themselves `lag` values later, -1..1, over
/// pairs within one stretch; 0 if there are none. Divided by the overall variance and the number of
/// pairs. For white noise within +-2/sqrt(n) in 95 % of cases.
double autocorrelation(const std::vector<double>& values,
                       const std::vector<recording::RowRange>& stretches, std::size_t lag);

/// Number of neighbouring values that count as one independent value: 1 + 2 sum of
/// autocorrelation(lag), summed until the lag is five times the result (Sokal's window) or a
/// quarter of the values; at least 1. The variance of a mean of n values is this times variance /
/// n.
double correlated_values(const std::vector<double>& values,
                         const std::vector<recording::RowRange>& stretches);

}  // namespace fogcomp::noise
