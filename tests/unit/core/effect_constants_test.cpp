// Constants of effects in a model table: their number, their ranges (as in the formulas), and the
// number of coefficients. Formats are those of the headers.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/effects/effect_check.hpp"

namespace {

using Constants = std::vector<std::int32_t>;

// Those that no board needs included.
constexpr fog::EffectMask kEveryEffect = ~fog::EffectMask{0};

bool accepted(std::size_t id, const Constants& constants, std::size_t coefficient_count) {
  const std::vector<std::int32_t> coefficients(coefficient_count, 1);
  fog::EffectParameters effect;
  effect.constants = constants.data();
  effect.coefficients = {coefficients.data(), coefficients.size()};
  return fog::effect_fits<kEveryEffect>(id, effect, constants.size());
}

constexpr std::int32_t kMax = INT32_MAX;
constexpr std::int32_t kMin = INT32_MIN;
constexpr std::int32_t k256Degrees = 256 << 22;
constexpr std::int32_t k256Degrees_q16 = 256 << 16;

struct EffectLimits {
  const char* name;
  std::size_t id;
  std::size_t coefficients;
  std::vector<Constants> good;
  std::vector<Constants> bad;
};

const EffectLimits kEffects[] = {
    {"bias", 0, 1, {{}}, {}},
    {"temperature_rate", 2, 1, {{}}, {}},
    {"shupe", 3, 1, {{1}, {kMax}}, {{0}, {-1}}},
    {"thermal_lag", 4, 1, {{1}, {kMax}}, {{0}, {-1}}},
    {"temperature_rate_product", 5, 1, {{}}, {}},
    {"axial_gradient", 6, 2, {{1, 1}, {kMax, kMax}}, {{0, 1}, {1, 0}, {-1, 1}, {1, -1}}},
    {"polarization_ripple, one",
     7,
     2,
     {{1, 0, kMin}, {kMax, 0, kMax}},
     {{0, 0, 0}, {-1, 0, 0}, {1, -1, 0}}},
    {"polarization_ripple, two", 7, 4, {{1, 1, 0}, {kMax, kMax, kMin}}, {{0, 1, 0}, {1, -1, 0}}},
    {"thermal_hysteresis, one",
     8,
     1,
     {{1, 1, 0, 0}, {k256Degrees - 1, 1, 0, 0}},
     {{0, 1, 0, 0}, {k256Degrees, 1, 0, 0}, {1, 1, -1, 0}}},
    {"thermal_hysteresis, two",
     8,
     2,
     {{1, 1, 1, 1}, {1, 1, k256Degrees - 1, 1}},
     {{0, 1, 1, 1}, {1, 1, k256Degrees, 1}}},
    {"glass_transition",
     9,
     2,
     {{0, 1, 0}, {k256Degrees - 1, kMax, kMax}, {1 - k256Degrees, 1, 0}},
     {{0, 0, 0}, {k256Degrees, 1, 0}, {-k256Degrees, 1, 0}, {0, -1, 0}, {0, 1, -1}}},
    {"scale_factor", 17, 1, {{}}, {}},
    {"scale_factor_temperature",
     10,
     2,
     {{2, k256Degrees_q16, kMax}, {2, -k256Degrees_q16, -kMax}},
     {{0, 0, 0}, {4, 0, 0}, {2, k256Degrees_q16 + 1, 0}, {2, -k256Degrees_q16 - 1, 0}}},
    {"scale_factor_nonlinearity", 18, 2, {{3, 1}, {3, kMax}}, {{1, 1}, {6, 1}, {3, 0}, {3, -1}}},
    {"scale_factor_asymmetry",
     19,
     1,
     {{1, 1}, {36864000, 119305}, {kMax, 3072}},
     {{0, 1}, {1, 0}, {kMax, 3073}, {kMax, kMax}}},
    {"warm_up", 11, 1, {{1}, {kMax}}, {{0}, {-1}}},
    {"aging",
     12,
     1,
     {{1, 0, 1}, {kMax, kMax, kMax}},
     {{0, 0, 1}, {-1, 0, 1}, {1, -1, 1}, {1, 0, 0}, {1, 0, -1}}},
    {"magnetic", 13, 2, {{}}, {}},
    {"vibration", 14, 1, {{}}, {}},
    {"light_power", 15, 1, {{}}, {}},
    {"bias_step", 16, 1, {{0}, {kMax}}, {{-1}}},
    {"late_reference", 20, 1, {{1, 0}, {kMax, kMin}}, {{0, 0}, {-1, 0}}},
};

TEST(EffectConstants, AreAcceptedUpToTheirLimitsAndRefusedBeyond) {
  for (const EffectLimits& effect : kEffects) {
    for (const Constants& constants : effect.good) {
      EXPECT_TRUE(accepted(effect.id, constants, effect.coefficients)) << effect.name;
      EXPECT_FALSE(accepted(effect.id, constants, effect.coefficients + 1)) << effect.name;
      EXPECT_FALSE(accepted(effect.id, constants, effect.coefficients - 1)) << effect.name;
      Constants more = constants;
      more.push_back(0);
      EXPECT_FALSE(accepted(effect.id, more, effect.coefficients)) << effect.name;
    }
    for (const Constants& constants : effect.bad) {
      EXPECT_FALSE(accepted(effect.id, constants, effect.coefficients))
          << effect.name << testing::PrintToString(constants);
    }
  }
}

TEST(EffectConstants, APolynomialHasAsManyCoefficientsAsItsOrderUpToNine) {
  for (std::int32_t order = 0; order <= 10; ++order) {
    for (std::size_t coefficients = 1; coefficients <= 10; ++coefficients) {
      const bool right =
          order >= 1 && order <= 9 && static_cast<std::size_t>(order) == coefficients;
      EXPECT_EQ(accepted(1, {order}, coefficients), right) << order << " " << coefficients;
    }
  }
}

// read_model() refuses it by its number.
TEST(EffectConstants, NumberOfNoEffect_NotLookedAt) {
  EXPECT_TRUE(accepted(fog::kMaxEffects - 1, {}, 0));
}

TEST(EffectConstants, OfAnEffectThatAnImageLeavesOutAreNotLookedAt) {
  fog::EffectParameters effect;
  EXPECT_TRUE(fog::effect_fits<0>(3, effect, 99));
  EXPECT_FALSE(fog::effect_fits<(1U << 3U)>(3, effect, 99));
}

}  // namespace
