#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace fogcomp::model {

/// The effects' number types on the host: double throughout. See fog::BoardNumbers.
struct RealNumbers {
  using Rate = double;
  using Temperature = double;
  using TemperatureRate = double;
  using Regressor = double;
  using Elapsed = double;
  /// The input rate within a block.
  struct RateWithin {
    double rise = 0;           ///< from the block's beginning to its end, deg/h
    double rise_of_slope = 0;  ///< the same of its derivative, deg/h/s
    /// deg/h, if they differ; owned by the series of the blocks.
    const double* samples = nullptr;
    std::size_t count = 0;
  };
  /// When the power came on last, and for how long it had been on and off before; blocks.
  struct PowerOn {
    double at = 0;
    double was_on = 0;
    double was_off = 0;
  };
  static double since(const PowerOn& start, double now) { return now - start.at; }
  /// `decay` after a start from cold, less what was left of the warmth before.
  static double from_cold(const PowerOn& start, double per_tau, double decay) {
    return decay * (1 + std::expm1(-start.was_on * per_tau) * std::exp(-start.was_off * per_tau));
  }
  template <int kFractionalBits>
  using Number = double;
  template <int kFractionalBits>
  using Wide = double;
  using Coefficient = double;
  using ScaleFactorError = double;
  using RateDrift = double;
  class ShareOf {
   public:
    explicit ShareOf(double whole) : whole_(whole) {}
    double operator()(double part) const { return part / whole_; }

   private:
    double whole_;
  };
  static double saturating_difference(double a, double b) { return a - b; }
  using Constant = double;
  template <int kFractionalBits>
  static double number(double constant) {
    return constant;
  }
  static std::int32_t integer(double constant) {
    return static_cast<std::int32_t>(std::lround(constant));
  }

  static double logistic(double x) { return 1 / (1 + std::exp(-x)); }
  static double exponential_decay(double x) { return std::exp(-std::max(x, 0.0)); }
  static double natural_logarithm(double x) { return std::log(x); }
  struct SineCosine {
    double sine;
    double cosine;
  };
  static SineCosine sine_cosine_of_turns(double turns) {
    constexpr double kRadiansPerTurn = 6.283185307179586;
    const double angle = kRadiansPerTurn * (turns - std::nearbyint(turns));
    return {std::sin(angle), std::cos(angle)};
  }

  // For board_constants, on the host only. 1 is replaced by the largest Number<31>.
  static constexpr double kMaxShare = 1 - 1.0 / 2147483648.0;
  static double share(double value) { return std::min(value, kMaxShare); }
  /// Decay per block of a lag with a time constant of 1 / blocks_per_tau blocks.
  static double decay(double blocks_per_tau) { return share(-std::expm1(-blocks_per_tau)); }
};

}  // namespace fogcomp::model
