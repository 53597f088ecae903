#pragma once

#include <cstdint>

#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/fixed_point/share.hpp"
#include "core/fixed_point/sine.hpp"

namespace fog {

// The physical quantities of the pipeline and their formats (SPEC.md, "Numbers").
using Rate = Fixed<std::int32_t, 10>;             ///< deg/h, also drift; LSB 0.00098, +-582 deg/s
using Temperature = Fixed<std::int32_t, 16>;      ///< degC, LSB 15 udegC
using TemperatureRate = Fixed<std::int32_t, 25>;  ///< degC/min, LSB 3e-8, +-64
using Regressor = Fixed<std::int32_t, 28>;        ///< dimensionless, +-8
using ExtensionValue = Fixed<std::int32_t, 16>;   ///< in the input's unit, +-32768
using Elapsed = Fixed<std::int32_t, 0>;           ///< blocks since power-on: 68 years of 1 s

/// Number types of the board, for templates that the host instantiates with real numbers
/// (RealNumbers): the fitted model and the flashed model have the same source.
struct BoardNumbers {
  using Rate = fog::Rate;
  using Temperature = fog::Temperature;
  using TemperatureRate = fog::TemperatureRate;
  using Regressor = fog::Regressor;
  using Elapsed = fog::Elapsed;
  struct RateWithin {};
  /// A value with F fractional bits.
  template <int kFractionalBits>
  using Number = Fixed<std::int32_t, kFractionalBits>;
  /// A slow state: 64 bits, so that a lag of 10^5 s still moves.
  template <int kFractionalBits>
  using Wide = Fixed<std::int64_t, kFractionalBits>;
  /// A board's time begins with its power-on, from cold. On the host a recording may go on after a
  /// restart.
  struct PowerOn {};
  static Elapsed since(PowerOn /*start*/, Elapsed now) { return now; }
  static Number<30> from_cold(PowerOn /*start*/, Number<31> /*per_tau*/, Number<30> decay) {
    return decay;
  }
  /// For effects that follow the input rate: a coefficient in deg/h, the same as a fraction of the
  /// rate, and their exact product with a rate.
  using Coefficient = Fixed<std::int64_t, 40>;
  using ScaleFactorError = Fixed<std::int32_t, 31>;
  using RateDrift = Fixed<std::int64_t, 41>;
  using ShareOf = fog::ShareOf;
  template <class Value>
  static Value saturating_difference(Value a, Value b) {
    return Value::from_raw(fog::saturating_difference(a.raw(), b.raw()));
  }
  /// A constant as the model table stores it: the raw integer.
  using Constant = std::int32_t;
  template <int kFractionalBits>
  static constexpr Number<kFractionalBits> number(Constant constant) {
    return Number<kFractionalBits>::from_raw(constant);
  }
  /// A constant that is a plain integer (an order, a count).
  static constexpr std::int32_t integer(Constant constant) { return constant; }

  // Functions used by the effects.
  static Number<30> logistic(Number<27> x) { return fog::logistic(x); }
  static Number<30> exponential_decay(Number<26> x) { return fog::exponential_decay(x); }
  template <int kFractionalBits>
  static Number<26> natural_logarithm(Wide<kFractionalBits> x) {
    return fog::natural_logarithm(x);
  }
  template <int kFractionalBits>
  static SineCosine sine_cosine_of_turns(Wide<kFractionalBits> turns) {
    return fog::sine_cosine_of_turns(turns);
  }
};

}  // namespace fog
