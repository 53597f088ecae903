#pragma once

#include <cstddef>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::noise {

/// Correlation of `values` (their overall mean removed) with themselves `lag` values later, -1..1,
/// over pairs that lie in one stretch; 0 where there are none. Divided by the variance of all and
/// the number of pairs. White noise stays within +-2/sqrt(n) 95 times in 100.
double autocorrelation(const std::vector<double>& values,
                       const std::vector<recording::RowRange>& stretches, std::size_t lag);

/// How many neighbouring values count as one: 1 + 2 sum of autocorrelation(lag), summed until the
/// lag is five times the result (Sokal's window) or a quarter of the values; at least 1. The
/// variance of a mean of n values is this times variance / n.
double correlated_values(const std::vector<double>& values,
                         const std::vector<recording::RowRange>& stretches);

}  // namespace fogcomp::noise
