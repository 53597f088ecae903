#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Creep of glue and moisture: logarithmic in time, linear for t much less than t0. So one shape
/// covers both laws, and a fit of a few hours does not diverge over years. The regressor is ln(1 +
/// t/t0) / 4: 4.4 after 68 years with t0 = 60 s.
///
/// Time is counted in blocks; ln(n + n0) - ln(n0) needs no division. n0 has 9 fractional bits: for
/// 60 blocks an error of 1.6e-5 of it, and as much in the logarithm. The two logarithms add 2e-8. A
/// t0 shorter than a block counts as one block.
template <class N>
class Aging {
  static constexpr int kOnsetFraction = 9;

 public:
  static constexpr EffectDescription description{
      "aging",
      12,
      "ageing, creep, moisture",
      "b = a ln(1 + t / t0), t since power-on; for t << t0 the line (a / t0) t",
      "0.001 to 0.05 deg/h per run or month",
      "t0=3600 a=0.02",
      "difference between two soaks at one temperature, on the same branch; no power cycle undoes "
      "it",
      "Moisture induced mechanical strain in gyroscope optical fiber coil",
      bit_of(Input::elapsed),
      nullptr,
      false,
      true};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"t0", "s", 60000, 2000000000, 3600000, Scale::logarithmic, nullptr, "a line in time"}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"a", "deg/h", 2}}};

  static constexpr std::array<int, 1> constant_fractions{kOnsetFraction};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = given[0] > block_s ? given[0] / block_s : Real{1};
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit Aging(const typename N::Constant* constants)
      : onset_(wide(N::template number<kOnsetFraction>(constants[0]))) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  // n + n0 < 2^32, so the logarithms stay below 22.2; their format holds 32.
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const auto logarithm =
        N::natural_logarithm(onset_ + wide(signals.block.elapsed)) - N::natural_logarithm(onset_);
    regressors[0] = saturate_to<typename N::Regressor>(divide_by_power_of_two<2>(logarithm));
  }

 private:
  using Blocks = typename N::template Wide<kOnsetFraction>;
  template <class T>
  static Blocks wide(T value) {
    return round_to<Blocks>(value);
  }

  Blocks onset_;
};

}  // namespace fog::effects
