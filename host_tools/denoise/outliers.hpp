#pragma once

#include <cstddef>

#include "core/signal/span.hpp"

namespace fogcomp::denoise {

/// Replaces outliers of one sample by the mean of their neighbours; returns how many. Wavelet
/// shrinkage keeps an outlier, because its coefficients stand far out of the noise. One is a value
/// that stands off both neighbours to the same side by more than
///   limit + |difference of the neighbours| + |difference of the two values before|
/// (firmware/core/denoise/outlier_gate.hpp: the same rule). Steps, ramps and oscillations stay.
std::size_t remove_outliers(fog::Span<double> values, double limit);

/// A limit that white noise passes once in millions of values: five standard deviations of the
/// noise, these from the median of differences between neighbours at up to 65536 places.
double outlier_limit(fog::Span<const double> values);

}  // namespace fogcomp::denoise
