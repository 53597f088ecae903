#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace fog::test {

/// First-order Gauss-Markov noise of standard deviation 1; neighbours correlate with `phi`.
inline std::vector<double> slow_noise(std::size_t count, double phi, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values{normal(random)};
  while (values.size() < count) {
    values.push_back(phi * values.back() + std::sqrt(1 - phi * phi) * normal(random));
  }
  return values;
}

}  // namespace fog::test
