#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace fogcomp::network {

/// Random numbers of the trainers. The distributions of the standard libraries differ; this does
/// not.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : bits_(seed) {}

  /// In [0, 1).
  double unit() { return std::ldexp(static_cast<double>(bits_() >> 11U), -53); }
  /// In [-size, size).
  double within(double size) { return size * (2 * unit() - 1); }
  /// 0 to count - 1.
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(unit() * static_cast<double>(count));
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace fogcomp::network
