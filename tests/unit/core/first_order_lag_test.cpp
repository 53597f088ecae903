#include "core/thermal/first_order_lag.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/signal/quantities.hpp"
#include "core/thermal/thermal_state.hpp"
#include "support/overflow_guard.hpp"

namespace {

using Lag = fog::FirstOrderLag<fog::BoardNumbers>;

Lag::State state(double value) {
  return Lag::State::from_raw(std::llround(std::ldexp(value, 40)));
}
double real(Lag::State value) {
  return std::ldexp(static_cast<double>(value.raw()), -40);
}
Lag::Decay decay(double tau_s) {
  return Lag::Decay::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(-std::expm1(-1 / tau_s), 31))));
}

// For blocks of 1 s.
fog::BoardNumbers::Number<24> rate_gain(double tau_s) {
  return fog::BoardNumbers::Number<24>::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(-std::expm1(-1 / tau_s) * 60, 24))));
}

TEST(FirstOrderLag, FollowsTheExponentialForEveryTimeConstant) {
  for (const double tau_s : {2.0, 10.0, 60.0, 1000.0, 1e5}) {
    Lag lag(decay(tau_s));
    lag.reset(state(-40));
    const int blocks = static_cast<int>(5 * tau_s);
    double worst = 0;
    for (int i = 1; i <= blocks; ++i) {
      const double exact = 60 - 100 * std::exp(-i / tau_s);
      worst = std::max(worst, std::abs(real(lag.step(state(60))) - exact));
    }
    // decay has 31 bits: tau = 10^5 s is known to 2.3e-5.
    EXPECT_LE(worst, 100 * tau_s * std::ldexp(1, -31)) << tau_s;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(FirstOrderLag, StillConvergesWithATimeConstantOfHundredThousandSeconds) {
  Lag lag(decay(1e5));
  lag.reset(state(0));
  for (int i = 0; i < 3000000; ++i) lag.step(state(0.001));
  EXPECT_NEAR(real(lag.value()), 0.001, 2e-7);
}

TEST(FirstOrderLag, StandsStillAtItsInput) {
  Lag lag(decay(30));
  lag.reset(state(25.3));
  for (int i = 0; i < 100000; ++i) lag.step(state(25.3));
  EXPECT_EQ(lag.value(), state(25.3));
}

TEST(ThermalState, HasTheRampsRateTwoTimeConstantsAfterItsStart) {
  constexpr double kTau = 30;
  fog::ThermalParameters<fog::BoardNumbers> parameters;
  parameters.derivative.decay = decay(kTau);
  parameters.derivative.rate_gain = rate_gain(kTau);
  parameters.min = fog::from_integer<fog::Temperature>(-50);
  parameters.max = fog::from_integer<fog::Temperature>(70);
  fog::ThermalState<fog::BoardNumbers> thermal(parameters);
  const auto at = [](double degc) {
    return fog::Temperature::from_raw(static_cast<std::int32_t>(std::lround(degc * 65536)));
  };
  thermal.reset({at(20)});
  for (int second = 1; second <= 600; ++second) {
    const auto signals = thermal.step({at(20 + 0.5 / 60 * second)});
    const double rate = std::ldexp(signals.temperature_rate.raw(), -25);
    const double exact = 0.5 * (1 - (1 + second / kTau) * std::exp(-second / kTau));
    ASSERT_NEAR(rate, exact, 0.01) << second;
    if (second > 12 * kTau) {
      ASSERT_NEAR(rate, 0.5, 2e-4) << second;
    }
  }
}

TEST(ThermalState, ClampsTemperatureToTheTrainedRangeButNotItsRate) {
  fog::ThermalParameters<fog::BoardNumbers> parameters;
  parameters.derivative.decay = decay(2);
  parameters.derivative.rate_gain = rate_gain(2);
  parameters.min = fog::from_integer<fog::Temperature>(-40);
  parameters.max = fog::from_integer<fog::Temperature>(60);
  fog::ThermalState<fog::BoardNumbers> thermal(parameters);
  thermal.reset({fog::from_integer<fog::Temperature>(60)});
  fog::Signals<fog::BoardNumbers> signals;
  for (int i = 1; i < 60; ++i) {
    signals = thermal.step({fog::Temperature::from_raw((60 << 16) + i * 65536 / 60)});
  }
  EXPECT_EQ(signals.temperature, parameters.max);
  EXPECT_NEAR(std::ldexp(signals.temperature_rate.raw(), -25), 1, 0.01);
}

}  // namespace
