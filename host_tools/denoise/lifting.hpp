#pragma once

#include <vector>

#include "core/signal/span.hpp"

namespace fogcomp::denoise {

/// Second-generation wavelet (Sweldens, SIAM J. Math. Anal. 29(2), 1998) in place, the (2,2) or 5/3
/// filter pair: every odd sample less the mean of its even neighbours is a detail; every even
/// sample takes up a quarter of its two details, which keeps the mean. Ends are mirrored; any
/// length. Delay in a stream is short, which is why it is proposed for gyros in real time.
struct LiftingParts {
  std::vector<std::vector<double>> details;  ///< the finest level first
  std::vector<double> approximation;
};

/// As many levels as asked for, or until one value is left.
LiftingParts lift(fog::Span<const double> values, int levels);
/// Undoes lift(): `values` has the length that was taken apart.
void unlift(const LiftingParts& parts, fog::Span<double> values);

}  // namespace fogcomp::denoise
