#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/signal/inputs.hpp"
#include "core/thermal/signals.hpp"

/* What an effect is made of. An effect is one header with a class template on the number types N
   (BoardNumbers in the firmware, RealNumbers on the host) that has

     static constexpr EffectDescription description;                who it is, for people
     static constexpr std::array<CoefficientDescription, R> coefficients;   one per regressor
     static constexpr std::array<ParameterDescription, P> parameters;       of its shape
     static constexpr std::array<int, C> constant_fractions;        formats of its board constants
     template <class Real> static void board_constants(...);        parameters -> constants
     static bool constants_valid(const typename N::Constant*);      may the constructor have them?
     explicit Effect(const typename N::Constant* constants);
     std::size_t regressor_count() const;                           at most R
     void reset(const Signals<N>&);                                 state at power-on
     void step(const Signals<N>&, typename N::Regressor*);          once per block

   (an effect without shape parameters inherits the middle four from NoParameters).
   board_constants runs on the host only and may use N's mathematics there (RealNumbers::decay).
   Drift = sum of coefficient * regressor over all effects, plus the network. Regressors are
   dimensionless and within +-8; the coefficients are identified on the host. */

namespace fog {

/// Text and identity of an effect. Costs nothing in an image that does not print it.
struct EffectDescription {
  const char* name;   ///< as on the command line
  std::uint8_t id;    ///< its number in the model table: never reused, never changed
  const char* title;  ///< what it is called in the literature
  const char* equation;
  const char* typical;    ///< magnitude in a tactical or navigation gyro
  const char* signature;  ///< how it shows in a residual
  const char* source;
  InputMask needs = 0;  ///< beside the coil's temperature
  /// Why the board cannot have it; nullptr where it can.
  const char* host_only = nullptr;
};

/// A shape parameter (order, time constant, period...). Bounds in thousandths of the unit, so that
/// they are integers here and the same on both sides.
struct ParameterDescription {
  const char* name;
  const char* unit;
  std::int32_t least_milli;
  std::int32_t most_milli;
  std::int32_t default_milli;
  bool whole;  ///< only whole numbers make sense
  /// What does as well as the effect where a search ends at that bound; nullptr: nothing simpler.
  const char* at_least = nullptr;
  const char* at_most = nullptr;
};

/// The coefficient in front of one regressor. regressor = signal in `unit`'s denominator /
/// 2^scale_log2, so the coefficient in natural units is coefficient / 2^scale_log2 * per_unit.
struct CoefficientDescription {
  const char* symbol;
  const char* unit;
  int scale_log2;
  std::int32_t per_unit = 1;  ///< natural units in one deg/h of the coefficient: 10^6 for ppm
};

/// Base of an effect whose shape has no parameters.
struct NoParameters {
  static constexpr std::array<ParameterDescription, 0> parameters{};
  static constexpr std::array<int, 0> constant_fractions{};
  /// `parameters` in the units of their descriptions and the block period in seconds -> what
  /// the constructor reads, each then held with the fractional bits of constant_fractions.
  template <class Real>
  static void board_constants(const Real* /*parameters*/, Real /*block_s*/, Real* /*constants*/) {}
  template <class Constant>
  static bool constants_valid(const Constant* /*constants*/) {
    return true;
  }
};

using EffectMask = std::uint32_t;  ///< bit = id
constexpr std::size_t kMostEffects = 32;

}  // namespace fog
