// The coverage of the intervals is tested in tests/statistics.
#include "noise/noise_coefficients.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "noise/allan_model.hpp"
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

TEST(NoiseCoefficients, SigmaOfATerm_IsThatOfTheStandard) {
  const auto sigma = [](AllanModel::Term term) { return sigma_of_term(term, 2, 7200); };
  EXPECT_NEAR(sigma(AllanModel::kQuantization), 2 * std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(sigma(AllanModel::kAngleWalk), 2 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(sigma(AllanModel::kInstability), 2 * 0.664, 1e-3);
  EXPECT_NEAR(sigma(AllanModel::kRateWalk), 2 * std::sqrt(2.0 / 3), 1e-12);
  EXPECT_NEAR(sigma(AllanModel::kRamp), 2 * std::sqrt(2.0), 1e-12);
}

TEST(NoiseCoefficients, BoundOfInstability_IsAboveTheLowestPoint) {
  std::vector<AllanPoint> allan(3);
  const double sigmas[] = {0.9, 0.6, 0.5};
  const double errors[] = {0.01, 0.032, 0.2};  // the last point is too uncertain
  for (std::size_t i = 0; i < allan.size(); ++i) {
    allan[i].sigma = sigmas[i];
    allan[i].one_sigma = errors[i];
  }
  EXPECT_DOUBLE_EQ(instability_bound_dph(allan), 0.664 / 0.664);
}

}  // namespace
}  // namespace fogcomp::noise
