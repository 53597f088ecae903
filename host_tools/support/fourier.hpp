#pragma once

#include <complex>
#include <vector>

namespace fogcomp {

/// Discrete Fourier transform of any number of values, in O(n log n): sum of v[i] e^(-2 pi i k /
/// n).
std::vector<std::complex<double>> fourier(const std::vector<std::complex<double>>& values);

}  // namespace fogcomp
