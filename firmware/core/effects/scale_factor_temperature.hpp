#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Scale factor that follows the source's wavelength and the coil's size: an error proportional to
/// the rate, up to a quarter of it. With x = T - lag dT/dt - reference the first regressor is
/// W x / 2^25 deg/h degC, each further one its predecessor times x / 64 degC. In steps of 64 degC
/// every coefficient is a scale factor error / 2^19; Horner's rule sums their polynomial once per
/// block, to 2^-35.
///
/// The lag stands, to first order, for a source or loop that is warmed later than the sensor, or,
/// where it is negative, earlier. It counts from the present block; the signals, of the block
/// before, are one block late already. Its bounds keep the drift at 582 deg/s within 2 LSB. With
/// the reference of its rows and no lag the first order is orthogonal to a constant scale factor
/// error.
template <class N>
class ScaleFactorTemperature {
  static constexpr std::int32_t kLsbsPerDegc = 1 << 16;
  static constexpr std::int32_t kMaxReference = 256;  // degC: 386 of any temperature
  static constexpr std::int32_t kMaxDistance = 386;
  static constexpr int kLagFraction = 24;

 public:
  static constexpr EffectDescription description{
      "scale_factor_temperature",
      10,
      "scale factor: source wavelength and coil size",
      "b = W sum over i = 1..order of ki (T - lag dT/dt - reference)^i, W the input rate",
      "k1 1 to 10 ppm/degC (erbium), 200 to 400 ppm/degC (SLD without cooler), coil 2 to 10 "
      "ppm/degC; k2 to 1 ppm/degC^2; lag of the source -4 to 4 min",
      "order=1 reference=20 lag=60 k1=300",
      "in proportion to the input rate and reversed with it, another size at each temperature; in "
      "one static position the same as bias_temperature",
      "US8254416; IEEE Std 952, scale factor temperature sensitivity",
      bit_of(Input::input_rate)};
  static constexpr std::array<ParameterDescription, 3> parameters{
      {{"order", "1", 1000, 3000, 1000, Scale::whole},
       {"reference", "degC", -100000, 200000, 20000, Scale::linear, nullptr, nullptr,
        NotGiven::mean_temperature},
       {"lag", "s", -240000, 240000, 0, Scale::linear, nullptr, nullptr, NotGiven::kept,
        Time::delay}}};
  static constexpr std::array<CoefficientDescription, 3> coefficients{
      {{"k1", "ppm/degC", 25, Multiplies::level, 1000000},
       {"k2", "ppm/degC^2", 31, Multiplies::level, 1000000},
       {"k3", "ppm/degC^3", 37, Multiplies::level, 1000000}}};

  static constexpr std::array<int, 3> constant_fractions{0, 16, kLagFraction};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = given[0];
    constants[1] = as_stored(given[1], kLsbsPerDegc);
    constants[2] = as_stored((given[2] - block_s) / 60, 1 << kLagFraction);
  }
  static bool constants_valid(const typename N::Constant* constants) {
    const auto max = from_integer<typename N::Temperature>(kMaxReference);
    const auto reference = N::template number<16>(constants[1]);
    return constants[0] >= 1 && constants[0] <= 3 && -max <= reference && reference <= max;
  }

  explicit ScaleFactorTemperature(const typename N::Constant* constants)
      : order_(static_cast<std::size_t>(N::integer(constants[0]))),
        reference_(N::template number<16>(constants[1])),
        lag_min_(N::template number<kLagFraction>(constants[2])) {}

  std::size_t regressor_count() const { return order_; }
  void set(const Signals<N>& signals, const typename N::Coefficient* given) {
    const auto x = distance(signals);
    Partial sum{};
    for (std::size_t i = order_; i-- > 0;) {
      const auto own = round_to<Partial>(divide_by_power_of_two<19>(given[i]));
      sum = held_within_one(own + round_to<Partial>(sum * x));
    }
    error_ = held_within<N, 2>(saturate_to<typename N::ScaleFactorError>(sum * x));
  }
  typename N::RateDrift at(typename N::Rate rate) const { return rate * error_; }

 private:
  // A constant as the board stores it, for the fit as well: half an LSB of the reference at 300
  // ppm/degC and 280 deg/s would be 0.002 deg/h, the whole error allowed to the integers.
  template <class Real>
  static Real as_stored(Real value, std::int32_t lsbs_per_unit) {
    const Real lsbs = value * lsbs_per_unit;
    return static_cast<Real>(static_cast<std::int64_t>(lsbs + (lsbs < 0 ? -1 : 1) / Real{2})) /
           lsbs_per_unit;
  }

  // Clipped to 1; times x, below 386 / 64, it is below 2^63.
  using Partial = typename N::template Wide<35>;
  static Partial held_within_one(Partial sum) {
    return clamp(sum, -from_integer<Partial>(1), from_integer<Partial>(1));
  }

  // From the reference to the late temperature, in 64 degC; finer than a temperature, because
  // 300 ppm/degC of 582 deg/s make 5 LSB of half an LSB of it.
  using Distance = typename N::template Number<25>;
  Distance distance(const Signals<N>& signals) const {
    using Far = typename N::template Wide<25>;
    const auto now = round_to<Far>(divide_by_power_of_two<6>(signals.temperature - reference_));
    const auto late = round_to<Far>(divide_by_power_of_two<6>(lag_min_ * signals.temperature_rate));
    const auto max = round_to<Far>(
        divide_by_power_of_two<6>(from_integer<typename N::Temperature>(kMaxDistance)));
    return round_to<Distance>(clamp(now - late, -max, max));
  }

  std::size_t order_;
  typename N::Temperature reference_;
  typename N::template Number<kLagFraction> lag_min_;
  typename N::ScaleFactorError error_{};
};

}  // namespace fog::effects
