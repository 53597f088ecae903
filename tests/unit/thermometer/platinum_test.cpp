#include "core/thermometer/platinum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/thermometer/resistance_thermometer.hpp"
#include "support/overflow_guard.hpp"

namespace {

using fog::ResistanceRatio;

// IEC 60751, in double.
double exact_ratio(double t) {
  const double below = t < 0 ? -4.183e-12 * (t - 100) * t * t * t : 0;
  return 1 + 3.9083e-3 * t - 5.775e-7 * t * t + below;
}

ResistanceRatio fixed(double ratio) {
  return ResistanceRatio::from_raw(static_cast<std::int32_t>(std::llround(std::ldexp(ratio, 28))));
}

double degc(fog::Temperature temperature) {
  return std::ldexp(temperature.raw(), -16);
}

TEST(Platinum, ReferenceIsTheTableOfTheStandard) {
  // Ohms of a Pt100, printed to 0.01 in IEC 60751, table 1.
  EXPECT_NEAR(100 * exact_ratio(-100), 60.26, 0.005);
  EXPECT_NEAR(100 * exact_ratio(-70), 72.33, 0.005);
  EXPECT_NEAR(100 * exact_ratio(0), 100.00, 0.005);
  EXPECT_NEAR(100 * exact_ratio(100), 138.51, 0.005);
  EXPECT_NEAR(100 * exact_ratio(200), 175.86, 0.005);
}

TEST(Platinum, TemperatureIsWithinATenThousandthOfTheStandard) {
  double worst = 0;
  double worst_t = 0;
  for (double t = -100; t <= 200; t += 0.0037) {
    const double error = std::abs(degc(fog::platinum_temperature(fixed(exact_ratio(t)))) - t);
    if (error > worst) worst_t = t;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_degc", std::to_string(worst));
  std::printf("worst error %.6f degC, at %.1f degC\n", worst, worst_t);
  EXPECT_LE(worst, 0.0001);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(Platinum, RatiosBeyondTheRangeGiveItsEnds) {
  EXPECT_NEAR(degc(fog::platinum_temperature(ResistanceRatio::lowest())), -100, 0.001);
  EXPECT_NEAR(degc(fog::platinum_temperature(ResistanceRatio::highest())), 200, 0.001);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

// What an ADC of so many codes, noisy by about a code, makes of a temperature.
class Converter {
 public:
  explicit Converter(double reference) : reference_(reference) {}
  std::uint32_t code(double ratio) {
    state_ = state_ * 1664525U + 1013904223U;
    const double noise = std::ldexp(static_cast<double>(state_), -32) * 2 - 1;
    return static_cast<std::uint32_t>(4096 * ratio / (ratio + reference_) + 0.5 + noise);
  }

 private:
  double reference_;
  std::uint32_t state_ = 1;
};

double measured(double t, double reference, fog::TemperatureReading& reading) {
  Converter converter(reference);
  fog::ResistanceThermometer thermometer(4096, fixed(reference));
  double sum = 0;
  constexpr int kReadings = 40;  // 20,000 codes: the noise is averaged away, errors of sums stay
  for (int i = 0; i < kReadings; ++i) {
    for (std::uint32_t n = 0; n < fog::ResistanceThermometer::kCodes; ++n) {
      thermometer.add(converter.code(exact_ratio(t)), 0);
    }
    reading = thermometer.reading(0);
    sum += degc(reading.temperature);
  }
  return sum / kReadings;
}

TEST(ResistanceThermometer, FollowsTheDividerOverItsWholeRangeWithinAHundredth) {
  for (const double reference : {0.5, 1.0, 2.2}) {
    for (double t = -70; t <= 130; t += 12.5) {
      fog::TemperatureReading reading;
      EXPECT_NEAR(measured(t, reference, reading), t, 0.01) << reference;
      EXPECT_TRUE(reading.valid);
    }
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(ResistanceThermometer, RefusesABrokenSensorAShortAndAConverterThatStops) {
  fog::ResistanceThermometer thermometer(4096, fixed(1));
  const auto feed = [&](std::uint32_t code) {
    for (std::uint32_t n = 0; n < fog::ResistanceThermometer::kCodes; ++n)
      thermometer.add(code, 50);
  };
  EXPECT_FALSE(thermometer.reading(50).valid) << "before the first reading";
  feed(2048);
  EXPECT_TRUE(thermometer.reading(50).valid);
  EXPECT_EQ(thermometer.reading(50).temperature.raw(), 0);
  EXPECT_TRUE(thermometer.reading(50 + fog::kOldestReadingMs).valid);
  EXPECT_FALSE(thermometer.reading(51 + fog::kOldestReadingMs).valid);
  thermometer.wait(50 + fog::kOldestReadingMs);
  EXPECT_TRUE(thermometer.reading(50).valid);
  thermometer.wait(51 + fog::kOldestReadingMs);
  EXPECT_FALSE(thermometer.reading(50).valid) << "when the clock has come round";
  for (const std::uint32_t code : {0U, 1U, 1000U, 3000U, 4095U}) {
    feed(code);
    EXPECT_FALSE(thermometer.reading(50).valid) << code;
  }
  feed(2048);
  EXPECT_TRUE(thermometer.reading(50).valid);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

}  // namespace
