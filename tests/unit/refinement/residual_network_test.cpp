#include "refinement/residual_network.hpp"

#include <gtest/gtest.h>

#include "support/typical_effects.hpp"
#include "unit/refinement/fitted_network.hpp"

namespace {

using namespace fog::test;

TEST(ResidualNetwork, IsNotKeptWhereThereIsNothingToLearn) {
  const FittedNetwork fitted = fit_network(truth(), kSlowNoise, 1, false);
  EXPECT_FALSE(fitted.model.network.present()) << "gain " << fitted.result.network_judged->gain;
  EXPECT_EQ(fitted.model.residual_rms_dph, fitted.result.effects_rms_dph);
}

TEST(ResidualNetwork, LearnsAnEffectThatIsLeftOut) {
  fogcomp::Model gyro = truth();
  gyro.terms.push_back(natural_term("polarization_ripple", {40, 0}, {0.03, 0.03}));
  const FittedNetwork fitted = fit_network(gyro, kQuietNoise, 1, false);
  ASSERT_TRUE(fitted.model.network.present());
  EXPECT_GT(fitted.result.network_judged->gain, 5 * fogcomp::kLeastGain);
  EXPECT_LT(mean_square(fitted.left_dph - fitted.network_dph), 0.1 * mean_square(fitted.left_dph));
}

}  // namespace
