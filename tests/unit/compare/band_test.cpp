#include "compare/model_on_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::compare {
namespace {

runs::Run run_with(double white_dph, std::uint64_t seed = 1) {
  return runs::run_of(fog::test::recording_of(fog::test::truth(), {white_dph, 0, 600}, seed), {10});
}

model::Model knowing(double white_dph) {
  model::Model model = fog::test::truth();
  model.uncertainty = model::Model::Uncertainty{};
  const Eigen::Index unknowns = model::unknowns_of(model);
  model.uncertainty->covariance = Eigen::MatrixXd::Zero(unknowns, unknowns);
  model.uncertainty->white_dph = white_dph;
  return model;
}

TEST(PredictiveBand, HoldsWhereTheNoiseIsAsKnown) {
  double within_1 = 0;
  double within_2 = 0;
  constexpr std::uint64_t kSeeds = 10;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::optional<PredictiveBand> band = band_of(knowing(0.024), run_with(0.024, seed));
    ASSERT_TRUE(band);
    within_1 += band->share_within(1) / kSeeds;
    within_2 += band->share_within(2) / kSeeds;
  }
  EXPECT_NEAR(within_1, 0.68, 0.05);
  EXPECT_NEAR(within_2, 0.95, 0.03);
}

TEST(PredictiveBand, DoesNotHoldWhereTheNoiseIsLarger) {
  const std::optional<PredictiveBand> band = band_of(knowing(0.024), run_with(0.24));
  ASSERT_TRUE(band);
  EXPECT_LT(band->share_within(2), 0.5);
}

TEST(PredictiveBand, IsWiderByTheUncertaintyOfACoefficient) {
  model::Model model = knowing(0.024);
  const double before_dph = band_of(model, run_with(0.024))->sigma_dph[0];
  constexpr double kBias_dph = 0.1;  // the first term's
  model.uncertainty->covariance(0, 0) = kBias_dph * kBias_dph;
  EXPECT_NEAR(band_of(model, run_with(0.024))->sigma_dph[0], std::hypot(before_dph, kBias_dph),
              1e-6);
}

TEST(PredictiveBand, IsNoneOfAModelFromBeforeItsUncertaintyWasKept) {
  EXPECT_FALSE(band_of(fog::test::truth(), run_with(0.024)));
}

}  // namespace
}  // namespace fogcomp::compare
