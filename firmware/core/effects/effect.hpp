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

   (an effect without shape parameters inherits the middle four from NoParameters). An effect that
   follows the input rate (below) has no state; instead of reset() and step(),

     void set(const Signals<N>&, const typename N::Coefficient*);   once per block
     typename N::RateDrift at(typename N::Rate) const;              its drift, once per sample

   in which each coefficient counts as itself: the regressors are at() of one that is 1. And, where
   a state does not forget what was before power-on by itself,

     bool history_known() const;                                    since then it has been put right

   and, where it has a state at all, what a restart of the board carries over,

     void carry(StateCarrier&);                                     its members, in any order

   board_constants runs on the host only and may use N's mathematics there (RealNumbers::decay).
   Drift = sum of coefficient * regressor over all effects, plus the network. Regressors are
   dimensionless and within +-8; the coefficients are identified on the host. */

namespace fog {

/// All that host, documents and tests know of an effect. No board reads more of it than `id`,
/// `needs` and `host_only`, and those while it is compiled: a description takes no flash.
struct EffectDescription {
  const char* name;   ///< as on the command line
  std::uint8_t id;    ///< its number in the model table: never reused, never changed
  const char* title;  ///< what it is called in the literature
  const char* equation;
  const char* typical;  ///< magnitude in a tactical or navigation gyro
  /// One such gyro, for documents and tests: "tau=120 K=1", shape parameters and as many
  /// coefficients as the effect then has, in their units.
  const char* example;
  const char* signature;  ///< how it shows in a residual
  const char* source;
  InputMask needs = 0;  ///< beside the coil's temperature
  /// Why the board cannot have it; nullptr where it can.
  const char* host_only = nullptr;
  /// A step of the bias at its only parameter, a time: it belongs to one recording, not to the
  /// gyro. A fit finds steps by change points.
  bool event = false;
  /// Its time goes on while the power is off: a board, which knows the time since power-on alone,
  /// would set it back each time. `export` refuses it.
  bool outlives_power = false;
};

/// Whether an effect is a function of the input rate now, beside the coil's temperature: it is
/// computed anew for every sample, so that it is not late where the rate moves. All others stand
/// for a block.
constexpr bool follows_input_rate(InputMask needs) {
  return needs == bit_of(Input::input_rate);
}

/// On which scale a fit searches the range of a shape parameter.
enum class Scale : std::uint8_t {
  linear,
  logarithmic,  ///< both bounds are positive
  frequency,    ///< that of 1 / value, of a period: what counts is how many turns the data hold
  whole,        ///< whole numbers, which are given and never searched for
};

/// What a shape parameter is where the user does not give it.
enum class NotGiven : std::uint8_t {
  identified,  ///< searched for, from its default on
  kept,        ///< its default
  /// 0, its default: without a second part of the effect like the one of the parameter before it.
  /// It is searched for where that one is.
  left_out,
  /// References that a fit takes from its rows once and the model keeps; their default is what they
  /// are in no fit: the mean of the temperature, each row as important as the square of its input
  /// rate, and the largest input rate, deg/s.
  mean_temperature,
  largest_input_rate,
};

/// A shape parameter (order, time constant, period...). Bounds in thousandths of the unit, so that
/// they are integers here and the same on both sides.
struct ParameterDescription {
  const char* name;
  const char* unit;
  std::int32_t min_milli;
  std::int32_t max_milli;
  std::int32_t default_milli;
  Scale scale;
  /// What does as well as the effect where a search ends at that bound; nullptr: nothing simpler.
  const char* at_least = nullptr;
  const char* at_most = nullptr;
  NotGiven not_given = NotGiven::identified;
};

/// What a coefficient multiplies.
enum class Multiplies : std::uint8_t {
  level,
  temperature_rate,  ///< comes and goes with dT/dt, and is as late as its lags
};

/// The coefficient in front of one regressor. regressor = signal in `unit`'s denominator /
/// 2^scale_log2, so the coefficient in natural units is coefficient / 2^scale_log2 * per_unit.
struct CoefficientDescription {
  const char* symbol;
  const char* unit;
  int scale_log2;
  Multiplies multiplies = Multiplies::level;
  std::int32_t per_unit = 1;  ///< natural units in one deg/h of the coefficient: 10^6 for ppm
};

/// Scale of regressors in proportion to the input rate: W / 2^18 deg/h is within +-8 for any rate.
constexpr int kScaleFactorLog2 = 18;

/// `error` within +-2^-kBits: the share of the rate that an effect may be. 1/2 for the constant
/// one, 1/4 with temperature, 1/8 for the asymmetry and 5 * 3/256 for the nonlinearity are less
/// than 1, so that their sum and the drift of the block stay within RateDrift.
template <class N, int kBits>
typename N::ScaleFactorError held_within(typename N::ScaleFactorError error) {
  const auto one = from_integer<typename N::template Number<0>>(1);
  const auto max = round_to<typename N::ScaleFactorError>(divide_by_power_of_two<kBits>(one));
  return clamp(error, -max, max);
}

/// The same of what a coefficient is of the rate, where its regressor is W / 2^18 deg/h.
template <class N, int kBits>
typename N::ScaleFactorError scale_factor_error(typename N::Coefficient coefficient) {
  return held_within<N, kBits>(saturate_to<typename N::ScaleFactorError>(
      divide_by_power_of_two<kScaleFactorLog2>(coefficient)));
}

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
constexpr std::size_t kMaxEffects = 32;

}  // namespace fog
