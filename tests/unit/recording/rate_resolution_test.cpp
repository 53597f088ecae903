#include "recording/recording.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/input_error.hpp"

namespace fogcomp::recording {
namespace {

Recording with_rates(const std::vector<double>& rates) {
  Recording recording;
  recording.file = "run.csv";
  recording.rate_dph = rates;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    recording.time_s.push_back(static_cast<double>(i));
    recording.temperature_degc.push_back(20);
  }
  return recording;
}

TEST(RateResolution, ADeadGyroIsRefused) {
  EXPECT_THROW(require_varying_rate(with_rates({0, 0, 0})), InputError);
  EXPECT_THROW(require_varying_rate(with_rates({0.5, 0.5, 0.5})), InputError);
}

TEST(RateResolution, RoundingDustIsNoRate) {
  EXPECT_THROW(require_varying_rate(with_rates({1e-16, -2e-16, 0})), InputError);
  EXPECT_THROW(require_varying_rate(with_rates({1e5, std::nextafter(1e5, 2e5), 1e5})), InputError);
}

TEST(RateResolution, WhatIsMeasuredMoves) {
  EXPECT_NO_THROW(require_varying_rate(with_rates({0.5, 0.5, 0.6})));
  EXPECT_NO_THROW(require_varying_rate(with_rates({1e-9, 2e-9, 0})));
  EXPECT_NO_THROW(require_varying_rate(with_rates({0.5})));  // too few rows to say so
}

TEST(RateResolution, RoundingIsThatOfTheDigits) {
  const RateResolution resolution = rate_resolution(with_rates({0.1, 0.3, 0.2, 0.2}));
  EXPECT_NEAR(resolution.rounding_dph(), 0.1 / std::sqrt(12), 1e-12);
}

}  // namespace
}  // namespace fogcomp::recording
