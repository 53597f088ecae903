#pragma once

#include <string>
#include <vector>

namespace fogcomp::denoise {

/// Decomposition low-pass filter of an orthogonal wavelet: haar, db2 to db10, sym2 to sym10, coif1
/// to coif5. Taps sum to sqrt 2, their squares to 1; order as PyWavelets' dec_lo. Throws InputError
/// for an unknown name.
const std::vector<double>& lowpass_filter(const std::string& wavelet);

/// The corresponding high-pass filter: PyWavelets' dec_hi.
std::vector<double> highpass_filter(const std::vector<double>& lowpass);

/// Names of all filters, family by family, shortest first.
const std::vector<std::string>& wavelet_names();

}  // namespace fogcomp::denoise
