#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Creep of glue and moisture: logarithmic in time, linear for t much less than t0. So one shape
/// covers both laws, and a fit of a few hours does not diverge over years. Both are faster when
/// warm: a block counts q10^((T - 20 degC) / 10) blocks (the law of Arrhenius about 20 degC). The
/// regressor is ln(1 + t/t0) / 4: 4.4 after 68 years with t0 = 60 s.
///
/// The age is a state that a gap or a restart does not reset. Without q10 it is the count of
/// blocks, exactly; with it 16 fractional bits, 0.4 % of a block at -40 degC and q10 = 2.5. ln(n +
/// n0) - ln(n0) needs no division. n0 has 9 fractional bits: for 60 blocks an error of 1.6e-5 of
/// it, and as much in the logarithm. The two logarithms add 2e-8. A t0 shorter than a block counts
/// as one block.
template <class N>
class Aging {
  static constexpr int kOnsetFraction = 9;
  static constexpr int kPerDegcFraction = 31;
  static constexpr int kSpeedFraction = 16;
  static constexpr int kHottest_degc = 130;

 public:
  static constexpr EffectDescription description{
      "aging",
      12,
      "ageing, creep, moisture",
      "b = a ln(1 + s / t0), ds/dt = q10^((T - 20 degC) / 10), s = 0 at power-on; for s << t0 the "
      "line (a / t0) s",
      "0.001 to 0.05 deg/h per run or month; q10 1.1 to 1.5 for 0.1 to 0.3 eV",
      "t0=3600 q10=1.3 a=0.02",
      "difference between two soaks at one temperature, on the same branch; no power cycle undoes "
      "it",
      "Moisture induced mechanical strain in gyroscope optical fiber coil; Arrhenius",
      bit_of(Input::elapsed),
      nullptr,
      false,
      true};
  static constexpr std::array<ParameterDescription, 2> parameters{
      {{"t0", "s", 60000, 2000000000, 3600000, Scale::logarithmic, nullptr, "a line in time"},
       {"q10", "1", 1000, 2500, 1000, Scale::linear, nullptr, nullptr, NotGiven::kept}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"a", "deg/h", 2}}};

  // t0 in blocks; ln(q10) / 10 degC; speed at the highest temperature, so that the exponential
  // decays towards all others.
  static constexpr std::array<int, 3> constant_fractions{kOnsetFraction, kPerDegcFraction,
                                                         kSpeedFraction};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = given[0] > block_s ? given[0] / block_s : Real{1};
    constants[1] = N::natural_logarithm(given[1]) / 10;
    constants[2] = Real{1} / N::exponential_decay(constants[1] * (kHottest_degc - 20));
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] > 0 && constants[1] >= 0 && constants[2] > 0;
  }

  explicit Aging(const typename N::Constant* constants)
      : onset_(round_to<Age>(N::template number<kOnsetFraction>(constants[0]))),
        per_degc_(N::template number<kPerDegcFraction>(constants[1])),
        hottest_speed_(N::template number<kSpeedFraction>(constants[2])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  // onset + age < 2^32, so the logarithms stay below 22.2; their format holds 32.
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    grow_older(signals.block.elapsed, speed(signals.temperature));
    const auto logarithm = N::natural_logarithm(onset_ + age_) - N::natural_logarithm(onset_);
    regressors[0] = saturate_to<typename N::Regressor>(divide_by_power_of_two<2>(logarithm));
  }

  void carry(StateCarrier& state) {
    state(age_);
    state(counted_);
  }

 private:
  using Age = typename N::template Wide<kSpeedFraction>;  // blocks at 20 degC
  using Speed = typename N::template Number<kSpeedFraction>;

  Speed speed(typename N::Temperature temperature) const {
    const auto hottest = from_integer<typename N::Temperature>(kHottest_degc);
    const auto below = hottest - (temperature < hottest ? temperature : hottest);
    const auto slower = saturate_to<typename N::template Number<26>>(below * per_degc_);
    return round_to<Speed>(N::exponential_decay(slower) * hottest_speed_);
  }

  // After a restart the time may begin again; the age goes on. Time passed times speed is below
  // 2^46 blocks.
  void grow_older(typename N::Elapsed now, Speed speed) {
    const auto longest = from_integer<Age>(std::numeric_limits<std::int32_t>::max());
    age_ = age_ + (now < counted_ ? now : now - counted_) * speed;
    if (age_ > longest) age_ = longest;
    counted_ = now;
  }

  Age onset_;
  typename N::template Number<kPerDegcFraction> per_degc_;
  Speed hottest_speed_;
  Age age_{};
  typename N::Elapsed counted_{};
};

}  // namespace fog::effects
