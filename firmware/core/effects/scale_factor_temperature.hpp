#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Scale factor that follows the source's wavelength and the coil's size: an error in proportion to
/// the rate. With x = T - reference the first regressor is W x / 2^25 deg/h degC: 570 deg/s at
/// 110 degC distance make 6.7. One LSB of it, 0.125 deg/h degC, is 4e-5 deg/h at 300 ppm/degC. Each
/// further one is the one before times x / 64 degC, rounded once.
///
/// About the reference of its rows the first order has nothing of a constant scale factor error.
template <class N>
class ScaleFactorTemperature {
  static constexpr std::int32_t kLsbsPerDegc = 1 << 16;

 public:
  static constexpr EffectDescription description{
      "scale_factor_temperature",
      10,
      "scale factor: source wavelength and coil size",
      "b = W sum over i = 1..order of ki (T - reference)^i, W the input rate",
      "k1 1 to 10 ppm/degC (erbium), 200 to 400 ppm/degC (SLD without cooler), coil 2 to 10 "
      "ppm/degC; k2 to 1 ppm/degC^2",
      "order=1 reference=20 k1=300",
      "in proportion to the input rate and reversed with it, another size at each temperature; in "
      "one static position the same as bias_temperature",
      "US8254416; IEEE Std 952, scale factor temperature sensitivity",
      bit_of(Input::input_rate)};
  static constexpr std::array<ParameterDescription, 2> parameters{
      {{"order", "1", 1000, 3000, 1000, Scale::whole},
       {"reference", "degC", -100000, 200000, 20000, Scale::linear, nullptr, nullptr,
        NotGiven::mean_temperature}}};
  static constexpr std::array<CoefficientDescription, 3> coefficients{
      {{"k1", "ppm/degC", 25, Multiplies::level, 1000000},
       {"k2", "ppm/degC^2", 31, Multiplies::level, 1000000},
       {"k3", "ppm/degC^3", 37, Multiplies::level, 1000000}}};

  static constexpr std::array<int, 2> constant_fractions{0, 16};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    constants[0] = given[0];
    // As the board holds it, for the fit too: half an LSB at 300 ppm/degC and 280 deg/s would be
    // 0.002 deg/h, all that the integers may be off.
    const Real lsbs = given[1] * kLsbsPerDegc;
    constants[1] =
        static_cast<Real>(static_cast<std::int64_t>(lsbs + (lsbs < 0 ? -1 : 1) / Real{2})) /
        kLsbsPerDegc;
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] >= 1 && constants[0] <= 3;
  }

  explicit ScaleFactorTemperature(const typename N::Constant* constants)
      : order_(static_cast<std::size_t>(N::integer(constants[0]))),
        reference_(N::template number<16>(constants[1])) {}

  std::size_t regressor_count() const { return order_; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto above = signals.temperature - reference_;
    auto power =
        saturate_to<Regressor>(divide_by_power_of_two<25>(above * signals.block.input_rate));
    for (std::size_t i = 0; i < order_; ++i) {
      regressors[i] = power;
      power = saturate_to<Regressor>(divide_by_power_of_two<6>(power * above));
    }
  }

 private:
  std::size_t order_;
  typename N::Temperature reference_;
};

}  // namespace fog::effects
