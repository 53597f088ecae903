#pragma once

#include <cmath>
#include <cstdint>

namespace fogcomp {

/// The effects' number types on the host: double throughout. See fog::BoardNumbers.
struct RealNumbers {
  using Rate = double;
  using Temperature = double;
  using TemperatureRate = double;
  using Regressor = double;
  using Elapsed = double;
  template <int kFractionalBits>
  using Number = double;
  template <int kFractionalBits>
  using Wide = double;
  using Constant = double;
  template <int kFractionalBits>
  static double number(double constant) {
    return constant;
  }
  static std::int32_t integer(double constant) {
    return static_cast<std::int32_t>(std::lround(constant));
  }
};

}  // namespace fogcomp
