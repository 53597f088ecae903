#include "compare/temperature_sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fogcomp::compare {
namespace {

constexpr double kHeating = 0.10;  // deg/h per degC/min
constexpr double kCooling = 0.08;

/// The paper's programme in rows of 10 s with a parabola in T and a rate term for each direction.
recording::Recording chamber_record(const std::vector<double>& levels_degc, double soak_min) {
  constexpr double kRampDegcPerMin = 0.5;
  constexpr double kPeriodMin = 1.0 / 6;
  recording::Recording rows;
  rows.period_s = 10;
  rows.stretch_starts = {0};
  const auto add = [&](double temperature, double rate) {
    rows.time_s.push_back(10 * static_cast<double>(rows.rows()));
    rows.temperature_degc.push_back(temperature);
    const double x = temperature - 20;
    rows.rate_dph.push_back(0.72 - 1.76e-4 * x - 3.15e-5 * x * x +
                            (rate > 0 ? kHeating : kCooling) * rate);
  };
  for (std::size_t i = 0; i < levels_degc.size(); ++i) {
    if (i > 0) {
      const double change = levels_degc[i] - levels_degc[i - 1];
      const double steps = std::fabs(change) / kRampDegcPerMin / kPeriodMin;
      for (double step = 0; step < steps; ++step) {
        add(levels_degc[i - 1] + change * step / steps, std::copysign(kRampDegcPerMin, change));
      }
    }
    for (double minute = 0; minute < soak_min; minute += kPeriodMin) add(levels_degc[i], 0);
  }
  return rows;
}

TEST(TemperatureSensitivity, IsRecoveredFromThePapersProgramme) {
  const recording::Recording rows = chamber_record({20, -40, 60, 20}, 120);
  const TemperatureSensitivity found =
      temperature_sensitivity(rows, recording::find_segments(rows));
  ASSERT_TRUE(found.bias_dph_per_degc.has_value());
  EXPECT_NEAR(*found.bias_dph_per_degc, 3.15e-5 * 60 - 1.76e-4, 1e-5);  // worst at -40
  EXPECT_NEAR(found.reference_degc.value_or(0), 20, 0.5);
  EXPECT_NEAR(found.heating_dph_per_degc_per_min.value_or(0), kHeating, 0.01 * kHeating);
  EXPECT_NEAR(found.cooling_dph_per_degc_per_min.value_or(0), kCooling, 0.01 * kCooling);
  EXPECT_NEAR(found.hysteresis_dph.value_or(0), 0.5 * (kHeating + kCooling), 0.01);
}

TEST(TemperatureSensitivity, IsAbsentWhereTheRecordingCannotShowIt) {
  const recording::Recording still = chamber_record({20}, 60);
  const TemperatureSensitivity at_rest =
      temperature_sensitivity(still, recording::find_segments(still));
  EXPECT_FALSE(at_rest.bias_dph_per_degc.has_value());
  EXPECT_FALSE(at_rest.heating_dph_per_degc_per_min.has_value());
  EXPECT_FALSE(at_rest.hysteresis_dph.has_value());

  const recording::Recording ramp =
      chamber_record({-40, 60}, 0);  // offset and rate term look the same
  const TemperatureSensitivity one_way =
      temperature_sensitivity(ramp, recording::find_segments(ramp));
  EXPECT_FALSE(one_way.heating_dph_per_degc_per_min.has_value());
  EXPECT_FALSE(one_way.cooling_dph_per_degc_per_min.has_value());
  EXPECT_FALSE(one_way.hysteresis_dph.has_value());
}

TEST(TemperatureSensitivity, OfOneRowIsAbsent) {
  recording::Recording one;
  one.time_s = one.temperature_degc = one.rate_dph = {1};
  one.stretch_starts = {0};
  const TemperatureSensitivity found = temperature_sensitivity(one, recording::find_segments(one));
  EXPECT_FALSE(found.bias_dph_per_degc.has_value());
}

}  // namespace
}  // namespace fogcomp::compare
