#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fogcomp::simulation {

/// xoshiro256++ (Blackman and Vigna 2019), one generator per named source: the stream depends on
/// the run's seed and the source's name only, so that switching one source on or off leaves every
/// other one's bits alone.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view source);

  std::uint64_t bits();
  /// In [0, 1), 53 bits.
  double uniform();
  /// Mean 0, variance 1, by a ziggurat of 256 layers (Marsaglia and Tsang 2000): about one table
  /// look-up and one multiplication a number, and the same bits on every standard library.
  double gaussian();

 private:
  double gaussian_tail(bool negative);

  std::array<std::uint64_t, 4> state_;
};

}  // namespace fogcomp::simulation
