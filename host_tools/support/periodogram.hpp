#pragma once

#include <vector>

namespace fogcomp {

/// |discrete Fourier transform|^2 / n of any number n of values, from frequency 0 up to below half
/// a cycle per value: element k is of k cycles in n. White noise has its variance in each.
std::vector<double> periodogram(const std::vector<double>& values);

}  // namespace fogcomp
