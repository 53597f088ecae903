// Ends of the ranges of single effects, and constants that stand for a parameter that is not given:
// what no typical gyro shows.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "core/effects/registry.hpp"
#include "model/real_numbers.hpp"

namespace fog {
namespace {

Signals<BoardNumbers> signals_at(std::int32_t degc, std::int32_t elapsed = 0) {
  Signals<BoardNumbers> signals;
  signals.temperature = from_integer<Temperature>(degc);
  signals.block.elapsed = Elapsed::from_raw(elapsed);
  return signals;
}

// All of an effect's regressors after one more block.
template <class Effect>
std::array<double, 4> step(Effect& effect, const Signals<BoardNumbers>& signals) {
  std::array<Regressor, 4> regressors{};
  effect.step(signals, regressors.data());
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) values[i] = std::ldexp(regressors[i].raw(), -28);
  return values;
}

template <template <class> class Effect>
std::array<double, 4> constants_of(const std::array<double, 4>& given, double block_s = 1) {
  std::array<double, 4> constants{};
  Effect<fogcomp::model::RealNumbers>::board_constants(given.data(), block_s, constants.data());
  return constants;
}

// At 20 degC ageing is as fast as time.
constexpr std::array<std::int32_t, 3> kAging{1 << 9, 0, 1 << 16};

TEST(Aging, TimeBeginsAgain_AgeGoesOn) {
  effects::Aging<BoardNumbers> once(kAging.data());
  effects::Aging<BoardNumbers> twice(kAging.data());
  step(twice, signals_at(20, 100));
  EXPECT_EQ(step(twice, signals_at(20, 10)), step(once, signals_at(20, 110)));
  EXPECT_EQ(step(twice, signals_at(20, 12)), step(once, signals_at(20, 112)));
}

TEST(Aging, OlderThanItCounts_Stands) {
  effects::Aging<BoardNumbers> aging(kAging.data());
  const double oldest = step(aging, signals_at(20, INT32_MAX))[0];
  EXPECT_NEAR(oldest, std::log(0x1p31) / 4, 1e-6);
  EXPECT_EQ(step(aging, signals_at(20, INT32_MAX - 1))[0], oldest);
}

TEST(Aging, HotterThanABoard_AsFastAsAtTheHottest) {
  const std::array<std::int32_t, 3> by_temperature{1 << 9, 1 << 26, 1 << 16};
  effects::Aging<BoardNumbers> hottest(by_temperature.data());
  effects::Aging<BoardNumbers> hotter(by_temperature.data());
  effects::Aging<BoardNumbers> cooler(by_temperature.data());
  const auto at_hottest = step(hottest, signals_at(130, 1000));
  EXPECT_EQ(step(hotter, signals_at(200, 1000)), at_hottest);
  EXPECT_LT(step(cooler, signals_at(120, 1000))[0], at_hottest[0]);
}

TEST(Aging, OnsetWithinABlock_IsABlock) {
  EXPECT_EQ(constants_of<effects::Aging>({0.5, 1})[0], 1);
  EXPECT_EQ(constants_of<effects::Aging>({2, 1})[0], 2);
}

TEST(BiasStep, AtItsTime_Whole) {
  const std::int32_t at = 100;
  effects::BiasStep<BoardNumbers> effect(&at);
  EXPECT_EQ(step(effect, signals_at(20, 99))[0], 0);
  EXPECT_EQ(step(effect, signals_at(20, 100))[0], 1);
}

TEST(BiasStep, TimeOfIt_InBlocks) {
  EXPECT_EQ(constants_of<effects::BiasStep>({3000}, 10)[0], 300);
}

// A reference that is late by 2^19 units of the coefficient, of blocks of 10 s.
TEST(LateReference, RateAndItsSlopeRise_SlopeOfThePast) {
  using Host = fogcomp::model::RealNumbers;
  const std::array<double, 4> constants = constants_of<effects::LateReference>({400}, 10);
  effects::LateReference<Host> effect(constants.data());
  Signals<Host> signals;
  signals.block.rate_within.rise = 500;
  signals.block.rate_within.rise_of_slope = 30;
  effect.reset(signals);
  double regressor = 0;
  effect.step(signals, &regressor);
  EXPECT_NEAR(std::ldexp(regressor, 19), (500 + 0.4 / 2 * 30) / 10, 1e-9);
}

TEST(GlassTransition, WithoutALag_FollowsAtOnce) {
  for (const bool has_lag : {false, true}) {
    const std::int32_t decay = has_lag ? 1 << 20 : 0;
    const std::array<std::int32_t, 3> constants{0, 1 << 29, decay};
    effects::GlassTransition<BoardNumbers> effect(constants.data());
    effect.reset(signals_at(60));
    EXPECT_NEAR(step(effect, signals_at(-60))[0], has_lag ? 0 : 1, 1e-3);
  }
  EXPECT_EQ(constants_of<effects::GlassTransition>({50, 4, 0})[2], 0);
  EXPECT_GT(constants_of<effects::GlassTransition>({50, 4, 100})[2], 0);
}

TEST(LightPower, NoLight_AsTheLeastThatIsMeasured) {
  const auto at = [](std::int32_t raw) {
    effects::LightPower<BoardNumbers> effect(nullptr);
    Signals<BoardNumbers> signals;
    signals.block[Input::light_power] = ExtensionValue::from_raw(raw);
    return step(effect, signals)[0];
  };
  EXPECT_EQ(at(0), at(1));
  EXPECT_EQ(at(INT32_MIN), at(1));
  EXPECT_LT(at(1), at(2));
}

TEST(PolarizationRipple, SecondPeriod_NotGiven_NoSecondWave) {
  const std::array<std::int32_t, 3> one{1 << 27, 0, 0};
  const std::array<std::int32_t, 3> two{1 << 27, 1 << 26, 0};
  effects::PolarizationRipple<BoardNumbers> single(one.data());
  effects::PolarizationRipple<BoardNumbers> both(two.data());
  EXPECT_NEAR(step(single, signals_at(20))[0], 1, 1e-8);
  EXPECT_EQ(step(single, signals_at(20))[2], 0);
  EXPECT_NEAR(step(both, signals_at(20))[2], 1, 1e-8);
  EXPECT_EQ(constants_of<effects::PolarizationRipple>({40, 0})[1], 0);
}

TEST(PolarizationRipple, PeriodBelowTheMinimum_IsTheMinimum) {
  EXPECT_EQ(constants_of<effects::PolarizationRipple>({40, 1})[1], 1.0 / 2);
  EXPECT_EQ(constants_of<effects::PolarizationRipple>({40, 8})[1], 1.0 / 8);
}

TEST(ThermalHysteresis, RadiusBelowTheMinimum_IsTheMinimum) {
  const std::array<double, 4> half_a_degree{0.5, 2, 4, 1.0 / 4};
  EXPECT_EQ(constants_of<effects::ThermalHysteresis>({0.1, 4}), half_a_degree);
}

TEST(ThermalHysteresis, SecondRadius_NotGiven_LeftOut) {
  const std::array<double, 4> one{4, 1.0 / 4, 0, 0};
  EXPECT_EQ(constants_of<effects::ThermalHysteresis>({4, 0}), one);
}

}  // namespace
}  // namespace fog
