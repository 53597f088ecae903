#pragma once

#include <string>
#include <vector>

namespace fogcomp {

/// Decomposition low-pass filter of an orthogonal wavelet: taps sum to sqrt 2, sum of squares 1,
/// order as PyWavelets' dec_lo. Throws InputError for an unknown name.
const std::vector<double>& lowpass_filter(const std::string& wavelet);

/// Names of all filters.
std::vector<std::string> wavelet_names();

}  // namespace fogcomp
