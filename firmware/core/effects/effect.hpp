#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/bytes/state_carrier.hpp"
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
     void reset(const Signals<N>&);                at power-on; after a gap, what a gap undoes
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

/// Description of an effect for host, documents and tests. A board uses only `id`, `needs` and
/// `host_only`, at compile time, so a description takes no flash.
struct EffectDescription {
  const char* name;   ///< as on the command line
  std::uint8_t id;    ///< its number in the model table: never reused, never changed
  const char* title;  ///< name in the literature
  const char* equation;
  const char* typical;  ///< magnitude in a tactical or navigation gyro
  /// Example for documents and tests, "tau=120 K=1": the shape parameters and all coefficients that
  /// the effect then has, in their units.
  const char* example;
  const char* signature;  ///< how it shows in a residual
  const char* source;
  InputMask needs = 0;  ///< beside the coil's temperature
  /// Why the board cannot run the effect; nullptr if it can.
  const char* host_only = nullptr;
  /// Step of the bias at the time that is its only parameter: it belongs to one recording, not to
  /// the gyro. A fit finds steps by change-point detection.
  bool event = false;
  /// Its time continues while the power is off. A board knows only the time since power-on and
  /// would restart the effect each time, so `export` refuses it.
  bool outlives_power = false;
};

/// Whether an effect depends on the present input rate and not only on block means. Such an effect
/// is evaluated for every sample, so that it is not late when the rate changes.
constexpr bool follows_input_rate(InputMask needs) {
  return needs == bit_of(Input::input_rate);
}

/// Scale on which a fit searches the range of a shape parameter.
enum class Scale : std::uint8_t {
  linear,
  place,        ///< linear: a temperature that the recordings have to pass
  logarithmic,  ///< both bounds are positive
  frequency,    ///< linear in 1 / value: for a period, turns within the data
  whole,        ///< whole numbers: given, never searched for
};

/// Value of a shape parameter that the user does not give.
enum class NotGiven : std::uint8_t {
  identified,  ///< searched for, starting at its default
  kept,        ///< its default
  /// 0, its default: the effect has no second part, which is like the first with this value in
  /// place of the parameter before it. Where that one is searched for, so is this one.
  left_out,
  /// Reference values that a fit computes once from its rows and the model keeps: mean temperature,
  /// each row weighted with the square of its input rate, and largest input rate, deg/s. Without a
  /// fit the default is used.
  mean_temperature,
  largest_input_rate,
};

/// What a shape parameter in seconds is to the effect.
enum class Time : std::uint8_t {
  other,             ///< a time since power-on; or the parameter is no time
  constant,          ///< of a state, which has to settle after a start
  constant_of_rate,  ///< the same, of dT/dt: in the model it follows the lags of the derivative
  delay,             ///< behind the present block: the block before, of which the board has the
                     ///< signals, is one block late already
};

/// A shape parameter (order, time constant, period...). Bounds in thousandths of the unit, because
/// the core has only integers.
struct ParameterDescription {
  const char* name;
  const char* unit;
  std::int32_t min_milli;
  std::int32_t max_milli;
  std::int32_t default_milli;
  Scale scale;
  /// What describes the data as well when a search ends at this bound; nullptr: nothing simpler.
  const char* at_least = nullptr;
  const char* at_most = nullptr;
  NotGiven not_given = NotGiven::identified;
  Time time = Time::other;
};

/// The quantity that a coefficient multiplies.
enum class Multiplies : std::uint8_t {
  level,
  temperature_rate,  ///< follows dT/dt, with the delay of its lags
};

/// The coefficient of one regressor. regressor = signal in the denominator of `unit` /
/// 2^scale_log2, so the coefficient in natural units is coefficient / 2^scale_log2 * per_unit.
struct CoefficientDescription {
  const char* symbol;
  const char* unit;
  int scale_log2;
  Multiplies multiplies = Multiplies::level;
  std::int32_t per_unit = 1;  ///< natural units in one deg/h of the coefficient: 10^6 for ppm
};

/// Scale of regressors proportional to the input rate: W / 2^18 deg/h is within +-8 for any rate.
constexpr int kScaleFactorLog2 = 18;

/// `error` clipped to +-2^-kBits, the largest part of the rate that an effect may be. Limits: 1/2
/// for the constant scale factor error, 1/4 for its temperature dependence, 1/8 for the asymmetry,
/// 5 * 3/256 for the nonlinearity. Their sum is below 1, so it and the drift of the block stay
/// within RateDrift.
template <class N, int kBits>
typename N::ScaleFactorError held_within(typename N::ScaleFactorError error) {
  const auto one = from_integer<typename N::template Number<0>>(1);
  const auto max = round_to<typename N::ScaleFactorError>(divide_by_power_of_two<kBits>(one));
  return clamp(error, -max, max);
}

/// The same for a coefficient whose regressor is W / 2^18 deg/h: the part of the rate that it is.
template <class N, int kBits>
typename N::ScaleFactorError scale_factor_error(typename N::Coefficient coefficient) {
  return held_within<N, kBits>(saturate_to<typename N::ScaleFactorError>(
      divide_by_power_of_two<kScaleFactorLog2>(coefficient)));
}

/// Base class of effects without shape parameters.
struct NoParameters {
  static constexpr std::array<ParameterDescription, 0> parameters{};
  static constexpr std::array<int, 0> constant_fractions{};
  /// Converts `parameters` (units of their descriptions) and the block period (s) to the values
  /// that the constructor reads; each is then stored with the fractional bits of
  /// constant_fractions.
  template <class Real>
  static void board_constants(const Real* /*parameters*/, Real /*block_s*/, Real* /*constants*/) {}
  template <class Constant>
  static bool constants_valid(const Constant* /*constants*/) {
    return true;
  }
};

using EffectMask = std::uint32_t;  ///< bit = id
constexpr std::size_t kMaxEffects = 32;

template <template <class> class... Effects>
struct EffectList {};

}  // namespace fog
