#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fogcomp {

/// xoshiro256++ (Blackman and Vigna 2019), one generator per named source. The stream depends only
/// on the run's seed and the source's name, so that enabling one source does not change the others.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view source);

  std::uint64_t bits();
  /// In [0, 1), 53 bits.
  double uniform();
  /// Mean 0, variance 1, by a ziggurat of 256 layers (Marsaglia and Tsang 2000): about one table
  /// look-up and one multiplication per number, and equal bits with every standard library.
  double gaussian();
  /// Mean and variance `shape`, 1 or more (Marsaglia and Tsang 2000).
  double gamma(double shape);

 private:
  double gaussian_tail(bool negative);

  std::array<std::uint64_t, 4> state_;
};

}  // namespace fogcomp
