#include "core/thermometer/platinum.hpp"

#include "core/fixed_point/shift.hpp"

namespace fog {
namespace {

using Celsius = Fixed<std::int32_t, 18>;
using Slope = Fixed<std::int32_t, 36>;

// Each with the fraction that its sum needs: C t (t - 100) is added to B, the result times t to A.
constexpr auto kA = Slope::from_raw(268576331);                    // 3.9083e-3
constexpr auto kB = Fixed<std::int32_t, 44>::from_raw(-10159487);  // -5.775e-7
constexpr auto kTwiceB = Fixed<std::int32_t, 43>::from_raw(-10159487);
constexpr auto kC = Fixed<std::int32_t, 50>::from_raw(-4710);  // -4.183e-12
constexpr auto kOne = ResistanceRatio::from_raw(1 << 28);

// W(-100 degC), W(200 degC).
constexpr auto kMinRatio = ResistanceRatio::from_raw(161748039);
constexpr auto kMaxRatio = ResistanceRatio::from_raw(472059856);

/// 1 + A t + B t^2 + C (t - 100) t^3, |t| <= 256 degC.
ResistanceRatio ratio_at(Celsius t) {
  auto b = kB;
  if (t < Celsius()) {
    const auto from_100 = round_to<Fixed<std::int32_t, 12>>(t - from_integer<Celsius>(100));
    const auto c_part = round_to<Fixed<std::int32_t, 50>>(kC * from_100);  // 8.4e-10 at most
    const auto t_coarse = round_to<Fixed<std::int32_t, 12>>(t);
    b += round_to<Fixed<std::int32_t, 44>>(c_part * t_coarse);
  }
  const Slope a = kA + round_to<Slope>(b * t);
  return kOne + round_to<ResistanceRatio>(a * t);
}

/// residual / slope. Slopes are A + 2 B t, 3.7e-3 to 4.03e-3 here.
Celsius divide(ResistanceRatio residual, Slope slope) {
  constexpr int kShift =
      Celsius::fractional_bits + Slope::fractional_bits - ResistanceRatio::fractional_bits;
  static_assert(-std::int64_t{INT32_MIN} <= floor_shift(kMaxDividend, kShift));
  const std::int64_t numerator = shift_left(std::int64_t{residual.raw()}, kShift);
  return Celsius::from_raw(static_cast<std::int32_t>(round_divide(numerator, slope.raw())));
}

}  // namespace

// Starts from the straight line, at most 6 degC off. Each step leaves less than a hundredth of the
// error: above 0 degC by Newton's convergence; below, C is left out of the slope, which is off by
// at most 1 %.
Temperature platinum_temperature(ResistanceRatio ratio) {
  const ResistanceRatio known = clamp(ratio, kMinRatio, kMaxRatio);
  Celsius t = divide(known - kOne, kA);
  for (int step = 0; step < 4; ++step) {
    t += divide(known - ratio_at(t), kA + round_to<Slope>(kTwiceB * t));
  }
  return round_to<Temperature>(t);
}

ResistanceRatio divider_ratio(std::uint32_t code_sum, std::uint32_t full_scale,
                              ResistanceRatio reference) {
  static_assert(INT32_MAX <= floor_shift(kMaxDividend, ResistanceRatio::fractional_bits));
  const auto over_reference =
      round_divide(shift_left(std::int64_t{code_sum}, ResistanceRatio::fractional_bits),
                   static_cast<std::int32_t>(full_scale - code_sum));
  const auto clipped = ResistanceRatio::from_raw(saturate<std::int32_t>(over_reference));
  return saturate_to<ResistanceRatio>(clipped * reference);
}

}  // namespace fog
