#pragma once

#include <vector>

namespace fogcomp {

/// |discrete Fourier transform|^2 / n of any number n of values, from frequency 0 to below half a
/// cycle per value: element k is for k cycles in n. The mean of each for white noise is its
/// variance.
std::vector<double> periodogram(const std::vector<double>& values);

}  // namespace fogcomp
