#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/random.hpp"

namespace fogcomp::bench {

/// All random numbers of a case, from one seed.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed, "hidden_effects") {}

  double uniform(double min, double max) { return min + (max - min) * random_.uniform(); }
  /// Uniform in the logarithm.
  double ratio(double min, double max) { return min * std::pow(max / min, random_.uniform()); }
  bool chance(double probability) { return random_.uniform() < probability; }
  double sign() { return chance(0.5) ? -1 : 1; }
  /// 0 ... count - 1.
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  template <class Value>
  const Value& pick(const std::vector<Value>& values) {
    return values[index(values.size())];
  }
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[index(i)]);
  }

 private:
  Random random_;
};

}  // namespace fogcomp::bench
