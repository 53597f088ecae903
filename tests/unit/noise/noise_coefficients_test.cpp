// The coverage of the intervals is tested in tests/statistics.
#include "noise/noise_coefficients.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/compare/noise_generator.hpp"

namespace fogcomp::noise {
namespace {

NoiseCoefficients fitted(const std::vector<double>& rate) {
  return fit_noise_coefficients(allan_deviation(rate, {{0, rate.size()}}, 1));
}

TEST(NoiseCoefficients, OfWhiteNoiseAreNAlone) {
  compare::NoiseTruth truth;
  truth.angle_random_walk_dprh = 0.00124;
  const NoiseCoefficients found = fitted(compare::make_noise(truth, 16384, 1, 1));
  ASSERT_TRUE(found.angle_random_walk_dprh.has_value());
  EXPECT_NEAR(found.angle_random_walk_dprh->value, 0.00124,
              1.5 * found.angle_random_walk_dprh->half_width_95);
  EXPECT_FALSE(found.quantization_deg.has_value());
  EXPECT_FALSE(found.bias_instability_dph.has_value());
  EXPECT_FALSE(found.rate_random_walk_dphrh.has_value());
  EXPECT_FALSE(found.rate_ramp_dphh.has_value());
}

TEST(NoiseCoefficients, AreAllAbsentWithoutNoise) {
  const NoiseCoefficients none = fit_noise_coefficients({});
  EXPECT_FALSE(none.angle_random_walk_dprh.has_value());
  EXPECT_FALSE(fitted(std::vector<double>(1000, 0.5)).angle_random_walk_dprh.has_value());
  fitted({1, 2, 1});  // one octave: no crash
}

}  // namespace
}  // namespace fogcomp::noise
