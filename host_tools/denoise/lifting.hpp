#pragma once

#include <vector>

#include "core/signal/span.hpp"

namespace fogcomp::denoise {

/// Second-generation wavelet (Sweldens, SIAM J. Math. Anal. 29(2), 1998) in place, the (2,2) or 5/3
/// filter pair: every odd sample less the mean of its even neighbours is a detail; every even
/// sample gets a quarter of its two details added, which keeps the mean. Ends are mirrored; any
/// length. Proposed for real-time gyros because of its short delay.
struct LiftingParts {
  std::vector<std::vector<double>> details;  ///< the finest level first
  std::vector<double> approximation;
};

/// Decomposes into `levels` levels, or until one value is left.
LiftingParts lift(fog::Span<const double> values, int levels);
/// Inverse of lift(): `values` has the original length.
void unlift(const LiftingParts& parts, fog::Span<double> values);

}  // namespace fogcomp::denoise
