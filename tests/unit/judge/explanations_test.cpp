#include "judge/explanations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "judge/rivals.hpp"
#include "support/random.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

constexpr Eigen::Index kSamples = 1200;
constexpr double kNoise_dph = 0.02;

Eigen::VectorXd column(const std::function<double(double)>& value) {
  Eigen::VectorXd all(kSamples);
  for (Eigen::Index i = 0; i < kSamples; ++i) all[i] = value(static_cast<double>(i) / kSamples);
  return all;
}

Eigen::VectorXd sine(double cycles) {
  return column([cycles](double t) { return std::sin(2 * kPi * cycles * t); });
}

// A model of a constant and a cycle, which the drift has, in white noise, and three effects that
// may be missing: two cycles, and one of two shapes.
class ExplanationsTest : public testing::Test {
 protected:
  explicit ExplanationsTest(std::uint64_t seed = 1) {
    rows_.row_s = 10;
    rows_.columns.resize(kSamples, 2);
    rows_.columns << Eigen::VectorXd::Ones(kSamples), sine(2.3);
    rows_.prior_sigma = Eigen::VectorXd::Zero(2);
    rows_.first_found = 2;
    rows_.weights = Eigen::VectorXd::Ones(kSamples);
    rows_.stretches = {{0, static_cast<std::size_t>(kSamples)}};
    rows_.drift_dph = 0.7 + 0.3 * sine(2.3).array();
    Random random(seed, "rows");
    for (double& value : rows_.drift_dph) value += kNoise_dph * random.gaussian();
    for (const double cycles : {3.1, 5.7, 7.9, 11.3}) shapes_.emplace_back(sine(cycles));
  }
  Explanations found() const {
    const ModeSpace space(rows_);
    std::vector<Eigen::MatrixXd> modes;
    for (const Eigen::MatrixXd& shape : shapes_) modes.push_back(space.of_effect(shape));
    return explain(space, smooth_, {{{modes[0]}}, {{modes[1]}}, {{modes[2], modes[3]}}});
  }

  Rows rows_;
  std::vector<Eigen::MatrixXd> shapes_;
  Eigen::MatrixXd smooth_{sine(1.3)};
};

TEST_F(ExplanationsTest, WhiteNoise_IsNothingMissing) {
  const Explanations explanations = found();
  EXPECT_GT(explanations.nothing, kMissingBefore[0]);
  EXPECT_TRUE(explanations.all.front().parts.empty());
  EXPECT_NEAR(explanations.noise_if_nothing.white_dph, kNoise_dph, 0.1 * kNoise_dph);
}

TEST_F(ExplanationsTest, RandomWalk_IsNothingMissing) {
  Random random(7, "walk");
  double walk = 0;
  for (double& value : rows_.drift_dph) value += walk += 0.01 * random.gaussian();
  const Explanations explanations = found();
  EXPECT_GT(explanations.nothing, 0.5);
  EXPECT_NEAR(explanations.noise_if_nothing.walk_dph_per_rth, 0.01 * std::sqrt(360), 0.08);
}

TEST_F(ExplanationsTest, ErrorsOfTheTemperature_AreNoiseWhereTheyShow) {
  constexpr double kWhite_degc2_s = 0.1;
  constexpr double kTau_s = 300;
  const auto sizes = [&](double slope_dph_per_degc) {
    rows_.temperature = {kWhite_degc2_s, kWhite_degc2_s / std::pow(kTau_s, 4), slope_dph_per_degc,
                         0};
    const ModeSpace space(rows_);
    const Rivals rivals(space, smooth_, {});
    std::set<double> all;
    for (const NoiseRatios& noise : possible_noises(rivals)) all.insert(noise.temperature);
    return all;
  };
  EXPECT_EQ(sizes(0.001), std::set<double>{1});
  EXPECT_EQ(sizes(1), (std::set<double>{0.25, 1, 4, 16}));
  const ModeSpace space(rows_);
  const Rivals rivals(space, smooth_, {});
  const Eigen::ArrayXd added = rivals.noise_density(0, 0, 1) - rivals.noise_density(0, 0, 0);
  const double expected = kWhite_degc2_s / rows_.row_s / rivals.white();
  EXPECT_NEAR(added.maxCoeff(), expected, 0.01 * expected);
  EXPECT_LT(added.minCoeff(), 1e-3 * expected);
}

// Slow noise that another recording has shown is no effect; if that one was white, it is missing.
TEST_F(ExplanationsTest, KnownNoise_IsNotLookedForInTheRows) {
  constexpr double kTau_s = 600;
  constexpr double kSlow_dph = 0.02;
  Random random(7, "slow");
  const double kept = std::exp(-rows_.row_s / kTau_s);
  double slow = 0;
  for (double& value : rows_.drift_dph) {
    slow = kept * slow + kSlow_dph * std::sqrt(1 - kept * kept) * random.gaussian();
    value += slow;
  }
  noise::NoiseModel known;
  known.row_s = rows_.row_s;
  known.white_variance = kNoise_dph * kNoise_dph;
  rows_.noise = known;
  EXPECT_LT(found().nothing, 0.01);
  rows_.noise->components = {{kTau_s, kSlow_dph * kSlow_dph}};
  EXPECT_GT(found().nothing, kMissingBefore[0]);
  EXPECT_EQ(found().noise_if_nothing.walk_dph_per_rth, 0);
}

TEST_F(ExplanationsTest, AnEffect_IsNamedWithItsShape) {
  rows_.drift_dph += 0.02 * sine(11.3);
  const Explanations explanations = found();
  EXPECT_GT(explanations.effects[2].probability, 0.95);
  EXPECT_EQ(explanations.effects[2].shape, 1U);
  EXPECT_GT(explanations.effects[2].largest, 0.95);
  EXPECT_GT(explanations.effects[2].log_odds, 5);
  EXPECT_GT(explanations.effects[2].explained, 0.9);
  EXPECT_LT(explanations.nothing, 0.01);
  EXPECT_LT(explanations.effects[0].probability, 0.2);
}

// As in a recording at one temperature.
TEST_F(ExplanationsTest, WithoutSmoothFunctions_AnEffectIsNamedAllTheSame) {
  smooth_.resize(kSamples, 0);
  rows_.drift_dph += 0.01 * sine(3.1);
  const Explanations explanations = found();
  ASSERT_EQ(explanations.all.front().parts.size(), 1U);
  EXPECT_EQ(explanations.all.front().parts[0].effect, 0U);
}

TEST_F(ExplanationsTest, TwoEffects_AreASetWithTheLargerFirst) {
  rows_.drift_dph += 0.05 * sine(3.1) + 0.02 * sine(5.7);
  const Explanations explanations = found();
  EXPECT_TRUE(explanations.all.front().has(0));
  EXPECT_TRUE(explanations.all.front().has(1));
  EXPECT_EQ(explanations.all.front().largest, 0U);
  EXPECT_GT(explanations.all.front().explained, 0.9);
  EXPECT_GT(explanations.effects[1].probability, 0.9);
  EXPECT_LT(explanations.effects[1].largest, 0.1);
}

// Each alone leaves nearly all.
TEST_F(ExplanationsTest, EffectsThatNearlyCancel_AreFoundTogether) {
  shapes_[1] = (sine(3.1) + 0.2 * sine(9.1));
  rows_.drift_dph += 0.02 * sine(9.1);
  const Explanations explanations = found();
  EXPECT_LT(explanations.effects[0].explained, 0.2);
  EXPECT_LT(explanations.effects[1].explained, 0.2);
  EXPECT_EQ(explanations.all.front().parts.size(), 2U);
  EXPECT_GT(explanations.all.front().probability, 0.9);
}

TEST_F(ExplanationsTest, EffectsThatLookAlike_ShareTheProbability) {
  shapes_[1] = 3 * shapes_[0];
  rows_.drift_dph += 0.03 * sine(3.1);
  const Explanations explanations = found();
  EXPECT_NEAR(explanations.effects[0].largest, explanations.effects[1].largest, 0.1);
  EXPECT_GT(explanations.effects[0].largest + explanations.effects[1].largest, 0.95);
}

TEST_F(ExplanationsTest, WhatNoEffectIs_IsSomethingElse) {
  rows_.drift_dph += 0.05 * sine(1.3);
  const Explanations explanations = found();
  EXPECT_GT(explanations.mostly_something_else, 0.9);
  EXPECT_LT(explanations.nothing, 0.01);
  EXPECT_GT(explanations.left_by_best, 0.5);
}

// The formula of the effect is a few per cent off: that alone is no reason for another effect.
TEST_F(ExplanationsTest, AnInexactFormula_IsNoSecondEffect) {
  rows_.drift_dph += 0.3 * sine(3.1) + 0.003 * sine(5.7);
  const Explanations explanations = found();
  EXPECT_GT(explanations.effects[0].probability, 0.99);
  EXPECT_LT(explanations.effects[1].probability, 0.5);
}

// Biases of power-ons bend slowly what an effect of hours would.
TEST_F(ExplanationsTest, BiasesOfPowerOns_AreNoEffect) {
  rows_.stretches = {{0, 400}, {400, 800}, {800, 1200}};
  rows_.power_ons = rows_.stretches;
  shapes_[0] = sine(0.5);
  rows_.drift_dph.segment(400, 400).array() += 0.3;
  EXPECT_GT(found().nothing, 0.5);
}

// Hides an effect of a multiple of the size that the rows say they would show.
TEST(Explanations, VisibleFrom_IsTheSizeOfWhichHalfIsFound) {
  struct Drawn : ExplanationsTest {
    Drawn(std::uint64_t seed, double times) : ExplanationsTest(seed) {
      constexpr double kRmsOfSine = 0.7071;
      const double size_dph = found().effects[1].visible_from_dph;
      rows_.drift_dph += times * size_dph / kRmsOfSine * sine(5.7);
    }
    void TestBody() override {}
    bool is_found() const { return found().nothing < kMissingBefore[0]; }
  };
  constexpr int kDraws = 40;
  const auto share = [](double times) {
    double found = 0;
    for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
      found += Drawn(seed, times).is_found() ? 1.0 / kDraws : 0;
    }
    return found;
  };
  EXPECT_LE(share(0.5), 0.2);
  EXPECT_NEAR(share(1), 0.55, 0.15);
  EXPECT_GE(share(2), 0.95);
}

// How often an effect is missing that is said to be with a probability.
TEST(Explanations, StatedProbabilities_AreTrueAsOftenAsTheySay) {
  struct Drawn : ExplanationsTest {
    explicit Drawn(std::uint64_t seed) : ExplanationsTest(seed) {
      Random random(seed, "hidden");
      is_missing = random.uniform() < 0.3;
      if (is_missing) rows_.drift_dph += kNoise_dph * 0.15 * sine(5.7);
    }
    void TestBody() override {}
    double stated() const { return found().effects[1].probability; }
    bool is_missing = false;
  };
  constexpr int kDraws = 60;
  double stated = 0;
  double missing = 0;
  double unlike = 0;
  for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
    const Drawn drawn(seed);
    const double probability = drawn.stated();
    stated += probability;
    missing += drawn.is_missing ? 1 : 0;
    unlike += std::abs(probability - (drawn.is_missing ? 1 : 0));
  }
  EXPECT_NEAR(stated, missing, 0.2 * kDraws);
  EXPECT_LT(unlike, 0.4 * kDraws);
}

}  // namespace
}  // namespace fogcomp::judge
