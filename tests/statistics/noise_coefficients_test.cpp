#include "noise/noise_coefficients.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "unit/compare/noise_generator.hpp"

namespace fogcomp {
namespace {

constexpr int kRecordings = 100;
constexpr int kEnough = 90;

noise::NoiseCoefficients fitted(const std::vector<double>& rate) {
  return noise::fit_noise_coefficients(noise::allan_deviation(rate, {{0, rate.size()}}, 1));
}

/// How often a coefficient was found, and how often its stated confidence interval contained the
/// truth (for a truth of 0: how often it was absent).
struct Tally {
  int found = 0;
  int right = 0;

  void count(const std::optional<noise::NoiseCoefficient>& estimate, double truth) {
    if (estimate) {
      ++found;
      if (std::fabs(estimate->value - truth) <= estimate->half_width_95) ++right;
    } else if (truth == 0) {
      ++right;
    }
  }
};

struct Tallies {
  Tally q, n, b, k, r;
};

Tallies simulate(const compare::NoiseTruth& truth) {
  constexpr std::size_t kSamples = 65536;
  Tallies tallies;
  for (int seed = 1; seed <= kRecordings; ++seed) {
    const noise::NoiseCoefficients found =
        fitted(compare::make_noise(truth, kSamples, 1, static_cast<std::uint64_t>(seed)));
    tallies.q.count(found.quantization_deg, truth.quantization_deg);
    tallies.n.count(found.angle_random_walk_dprh, truth.angle_random_walk_dprh);
    tallies.b.count(found.bias_instability_dph, truth.bias_instability_dph);
    tallies.k.count(found.rate_random_walk_dphrh, truth.rate_random_walk_dphrh);
    tallies.r.count(found.rate_ramp_dphh, truth.rate_ramp_dphh);
  }
  return tallies;
}

TEST(NoiseCoefficients, OfWhiteNoiseAreNAlone) {
  compare::NoiseTruth truth;
  truth.angle_random_walk_dprh = 0.00124;
  const Tallies tallies = simulate(truth);
  EXPECT_GE(tallies.n.right, kEnough);
  for (const Tally& absent : {tallies.q, tallies.b, tallies.k, tallies.r}) {
    EXPECT_GE(absent.right, 95);
  }
}

TEST(NoiseCoefficients, OfAFogWithFlickerNoiseAreNAndB) {
  compare::NoiseTruth truth;
  truth.angle_random_walk_dprh = 0.00124;
  truth.bias_instability_dph = 0.003;
  const Tallies tallies = simulate(truth);
  EXPECT_GE(tallies.n.right, kEnough);
  EXPECT_GE(tallies.b.right, kEnough);
  EXPECT_GE(tallies.k.right, 95);
}

TEST(NoiseCoefficients, AreFoundWhereFourShapesFollowEachOther) {
  compare::NoiseTruth truth;
  truth.quantization_deg = 3e-6;
  truth.angle_random_walk_dprh = 0.0005;
  truth.bias_instability_dph = 0.01;
  truth.rate_random_walk_dphrh = 0.05;
  const Tallies tallies = simulate(truth);
  EXPECT_GE(tallies.q.right, kEnough);
  EXPECT_GE(tallies.n.right, kEnough);
  EXPECT_GE(tallies.b.right, kEnough);
  EXPECT_GE(tallies.k.right, kEnough);
}

TEST(NoiseCoefficients, FindARateRamp) {
  compare::NoiseTruth truth;
  truth.angle_random_walk_dprh = 0.001;
  truth.rate_ramp_dphh = 0.05;
  const Tallies tallies = simulate(truth);
  EXPECT_GE(tallies.n.right, kEnough);
  EXPECT_GE(tallies.r.right, kEnough);
}

TEST(NoiseCoefficients, AreAbsentRatherThanWrongWhereTwoCouldStandForEachOther) {
  compare::NoiseTruth truth;  // a walk that the flicker floor all but hides
  truth.angle_random_walk_dprh = 0.00124;
  truth.bias_instability_dph = 0.003;
  truth.rate_random_walk_dphrh = 0.005;
  const Tallies tallies = simulate(truth);
  EXPECT_GE(tallies.n.right, kEnough);
  EXPECT_LE(tallies.k.found - tallies.k.right, 5);
  EXPECT_LE(tallies.b.found - tallies.b.right, 10);
}

}  // namespace
}  // namespace fogcomp
