#include "identification/independent_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace {

using fogcomp::independent_share;
using fogcomp::NoiseModel;

NoiseModel noise_with(std::vector<NoiseModel::Component> components) {
  NoiseModel noise;
  noise.row_s = 10;
  noise.white_variance = 4;
  noise.components = std::move(components);
  return noise;
}

TEST(IndependentShare, IsOneForWhiteNoise) {
  EXPECT_EQ(independent_share(noise_with({})), 1);
}

// Far below an hour a component's density is variance * (1 + phi) / (1 - phi).
TEST(IndependentShare, IsTheInverseOfWhatSlowNoiseAddsToTheMean) {
  const double phi = std::exp(-10.0 / 40);
  const double density = 4 + 1 * (1 + phi) / (1 - phi);
  EXPECT_NEAR(independent_share(noise_with({{40, 1}})), 4 / density, 0.002);
}

TEST(IndependentShare, LeavesAloneWhatIsFarSlowerThanAnHour) {
  EXPECT_GT(independent_share(noise_with({{1e7, 1}})), 0.95);
}

}  // namespace
