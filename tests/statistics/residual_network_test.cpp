// A network on the residual of effects learns an effect that is left out, and not the slow noise.
#include <gtest/gtest.h>

#include "statistics/fitted_network.hpp"
#include "support/typical_effects.hpp"

namespace {

using namespace fog::test;

TEST(NetworkOnNoise, LearnsNextToNothing) {
  constexpr int kGyros = 10;
  double square = 0;
  for (std::uint64_t seed = 1; seed <= kGyros; ++seed) {
    square += mean_square(fit_network(truth(), kSlowNoise, seed, true).network_dph);
  }
  EXPECT_LT(std::sqrt(square / kGyros), 0.0024) << "deg/h rms, forced to stay";
}

TEST(NetworkOnNoise, IsNotKept) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const FittedNetwork fitted = fit_network(truth(), kSlowNoise, seed, false);
    EXPECT_FALSE(fitted.model.network.present())
        << "gain " << fitted.result.network_judged->score.gain;
    EXPECT_EQ(fitted.model.residual_rms_dph, fitted.result.effects_rms_dph);
  }
}

TEST(NetworkOnAnEffect, LearnsItAndIsTheSameAgainForcedOrNot) {
  fogcomp::model::Model gyro = truth();
  gyro.terms.push_back(natural_term("polarization_ripple", {40, 0}, {0.03, 0.03}));
  const FittedNetwork fitted = fit_network(gyro, kQuietNoise, 1, false);
  ASSERT_TRUE(fitted.model.network.present());
  EXPECT_TRUE(fitted.result.network_judged->score.improves());
  EXPECT_LT(mean_square(fitted.left_dph - fitted.network_dph), 0.1 * mean_square(fitted.left_dph));
  EXPECT_EQ(fit_network(gyro, kQuietNoise, 1, true).network_dph, fitted.network_dph);
}

}  // namespace
