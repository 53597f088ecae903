#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fog::test {

/// Largest change of the output when details up to 1 are removed on each level, level 1 first: the
/// largest phase sum of the magnitude of the synthesis response. The response of a level is its
/// high-pass synthesis filter passed through the low-pass ones of the finer levels. `low`: the
/// orthonormal decomposition filter.
inline std::vector<double> removal_bounds(const std::vector<double>& low, int levels) {
  const std::size_t taps = low.size();
  std::vector<double> bounds;
  for (int level = 1; level <= levels; ++level) {
    std::vector<double> response;
    for (std::size_t i = 0; i < taps; ++i) {
      response.push_back((i % 2 == 0 ? -1 : 1) * std::sqrt(2) * low[i]);
    }
    std::size_t period = 2;
    for (int finer = level - 1; finer > 0; --finer, period *= 2) {
      std::vector<double> longer(2 * response.size() + taps, 0.0);
      for (std::size_t n = 0; n < response.size(); ++n) {
        for (std::size_t i = 0; i < taps; ++i) {
          longer[2 * n + i] += response[n] * std::sqrt(2) * low[taps - 1 - i];
        }
      }
      response = longer;
    }
    double largest = 0;
    for (std::size_t phase = 0; phase < period; ++phase) {
      double sum = 0;
      for (std::size_t n = phase; n < response.size(); n += period) sum += std::abs(response[n]);
      largest = std::max(largest, sum);
    }
    bounds.push_back(largest);
  }
  return bounds;
}

/// Largest error due to 16 bits of noise and 15 of synthesis taps, relative to the bound of the
/// noise.
constexpr double kNoiseResolution = 1.0 / 2000;

}  // namespace fog::test
