#pragma once

#include <cstddef>

#include "core/signal/span.hpp"

namespace fogcomp::denoise {

/// Replaces outliers of one sample by the mean of their neighbours; returns their number. Wavelet
/// shrinkage would keep an outlier, because its coefficients exceed the threshold. An outlier
/// differs from both neighbours, in the same direction, by more than
///   limit + |difference of the neighbours| + |difference of the two values before|
/// (the rule of firmware/core/denoise/outlier_gate.hpp). Steps, ramps and oscillations are kept.
std::size_t remove_outliers(fog::Span<double> values, double limit);

/// A limit that white noise exceeds once in millions of values: five standard deviations of the
/// noise, from the median difference of neighbours at up to 65536 positions.
double outlier_limit(fog::Span<const double> values);

}  // namespace fogcomp::denoise
