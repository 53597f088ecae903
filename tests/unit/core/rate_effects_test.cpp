// Effects that follow the input rate, as computed once per sample.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/effects/effect_bank.hpp"
#include "support/overflow_guard.hpp"

namespace fog {
namespace {

TEST(ShareOf, IsWithinThreeOfItsLsbsAndNeverOne) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto whole = static_cast<std::int32_t>((random() >> 1U) >> (random() % 31U)) | 1;
    const auto part =
        static_cast<std::int32_t>(whole / 2000.0 * static_cast<double>(random() % 2001U));
    const ShareOf share_of(Rate::from_raw(whole));
    for (const std::int32_t signed_part : {part, -part, whole, -whole}) {
      const auto share = share_of(Rate::from_raw(signed_part));
      const double exact = std::ldexp(double(signed_part) / whole, 31);
      ASSERT_NEAR(share.raw(), exact, 3) << signed_part << " of " << whole;
    }
  }
}

constexpr EffectMask kRateEffects = rate_effects(Registry{}) & kAllEffects;

// Every coefficient of every effect as large as a table can have it, with any sign.
struct LargestTable {
  explicit LargestTable(std::uint32_t signs) {
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      coefficients[i] = (signs >> i) % 2U == 0U ? INT32_MAX : INT32_MIN;
    }
    parameters.coefficient_fraction = kMinCoefficientFraction;
    parameters.by_id[17] = {constants.data(), {&coefficients[0], 1}};
    parameters.by_id[10] = {&constants[0], {&coefficients[1], 3}};
    parameters.by_id[18] = {&constants[2], {&coefficients[4], 4}};
    parameters.by_id[19] = {&constants[4], {&coefficients[8], 1}};
  }
  std::array<std::int32_t, 6> constants{3, -256 * 65536, 5, 123456789, 3600, 1 << 20};
  std::array<std::int32_t, 9> coefficients{};
  EffectsParameters parameters;
};

TEST(RateEffects, OfAnyTableStayInRangeAtAnyRate) {
  const Rate::Raw rates[] = {INT32_MIN, INT32_MIN + 1, -123456789, -3600, 0,
                             1,         123456789,     INT32_MAX};
  BoardNumbers::RateDrift max{};
  for (std::uint32_t signs = 0; signs < 512; ++signs) {
    const LargestTable table(signs);
    EffectBank<kRateEffects> bank(table.parameters);
    for (const Temperature::Raw temperature : {-70 * 65536, 130 * 65536}) {
      Signals<BoardNumbers> signals;
      signals.temperature = Temperature::from_raw(temperature);
      bank.set(signals);
      for (const Rate::Raw rate : rates) {
        const auto drift = bank.at(Rate::from_raw(rate), {});
        max = std::max(max, drift);
      }
    }
  }
  // Less than the highest rate, to leave range for the drift of a block.
  EXPECT_GT(std::ldexp(max.raw(), -41), 0.8 * 0x1p21);
  EXPECT_LT(std::ldexp(max.raw(), -41), 0x1p21);
  EXPECT_EQ(test::overflows(), 0U);
}

}  // namespace
}  // namespace fog
