#include "diagnosis/walk_finding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/diagnosis/made_evidence.hpp"

namespace fogcomp::diagnosis {
namespace {

using noise::NoiseModel;

constexpr double kWalk = 0.01;  // deg/h/sqrt(h)
constexpr Eigen::Index kModes = 8;

// Orthogonal rows: four effects, two smooth functions, the modes of a walk, and many empty ones.
// White noise of variance 1 in all; a walk of kWalk moves the first mode by 30 times that, the next
// ones by a half, a third...
class WalkingRows {
 public:
  WalkingRows() : axes_(Eigen::MatrixXd::Identity(200, 200)), residual_(200) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (double& value : residual_) value = normal(random);
  }
  void walk() {
    for (Eigen::Index k = 0; k < kModes; ++k) residual_[6 + k] += 30.0 / static_cast<double>(k + 1);
  }
  void effect(double size) { residual_[0] += size; }

  WalkFinding weigh(const NoiseModel& noise) const {
    static const fog::test::MadeEvidence made(fog::test::thinned(
        fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1), 20));
    EvidenceSpace evidence = made.evidence();
    evidence.space = fit::ExplainedSpace(residual_);
    evidence.candidates.clear();
    evidence.regressors.clear();
    Eigen::Index axis = 0;
    for (const char* const effect : {"temperature_rate", "thermal_hysteresis:radius=5", "aging",
                                     "polarization_ripple:period=9"}) {
      const model::EffectTerm term = model::parse_effects(effect)[0];
      evidence.candidates.push_back({term.name, {{term, axes_.col(axis++).cast<float>(), 0}}});
      evidence.regressors.push_back(
          {evidence.space.add(evidence.candidates.back().shapes[0].basis)});
    }
    const Eigen::MatrixXf structure = axes_.middleCols(4, 2).cast<float>();
    evidence.structure = evidence.space.add(structure);
    Eigen::MatrixXf modes = axes_.middleCols(6, kModes).cast<float>();
    for (Eigen::Index k = 0; k < kModes; ++k)
      modes.col(k) *= static_cast<float>(30 / kWalk / static_cast<double>(k + 1));
    evidence.walk = fit::add_walk(evidence.space, modes);
    evidence.space.finish();
    return assess_walk(evidence,
                       find_hypotheses(evidence.space, evidence.candidates, evidence.regressors),
                       noise, 1);
  }

 private:
  Eigen::MatrixXd axes_;
  Eigen::VectorXd residual_;
};

// Quiet parts that allow several walks equally, and determine the noise well.
NoiseModel quiet_noise() {
  NoiseModel noise;
  noise.from_quiet_parts = true;
  noise.degrees_of_freedom = 200;
  noise.white_variance = 1;
  noise.walks = {{kWalk / 16, 0}, {kWalk, 0}, {kWalk * 16, 0}};
  return noise;
}

// Neither effects nor structure show anything beside it: a walk with neither, with one, with the
// other.
TEST(WalkFinding, OfAWalkIsTheLikeliestOneAndAloneEnough) {
  WalkingRows rows;
  rows.walk();
  const WalkFinding finding = rows.weigh(quiet_noise());
  EXPECT_EQ(finding.coefficient, kWalk);
  EXPECT_NEAR(finding.chance, 1.0 / 3, 0.1);
  EXPECT_TRUE(finding.may_be_all());
  EXPECT_GT(finding.noise_alone, 0.01);
}

// An effect that exceeds noise with a walk is not explained by the walk.
TEST(WalkFinding, IsImprobableWhereAnEffectStandsOutOfIt) {
  WalkingRows rows;
  rows.walk();
  rows.effect(40);
  const WalkFinding finding = rows.weigh(quiet_noise());
  EXPECT_LT(finding.chance, 1e-9);
  EXPECT_FALSE(finding.may_be_all());
}

TEST(WalkFinding, SaysHowProbableTheWalkIs) {
  const WalkFinding as_well{0.01, 0.6, 1, true};
  EXPECT_NE(as_well.words().find("explains them as well as any effect"), std::string::npos);
  const WalkFinding hardly{0.01, 0.0002, 1, true};
  EXPECT_TRUE(hardly.may_be_all());
  EXPECT_FALSE((WalkFinding{0.01, 0.0002, 1, false}.may_be_all()));
  EXPECT_NE(hardly.words().find("has a probability of 0.0002"), std::string::npos);
}

TEST(WalkFinding, IsNoneInWhiteNoise) {
  EXPECT_EQ(WalkingRows().weigh(quiet_noise()).coefficient, 0);
}

TEST(WalkFinding, IsNoneThatTheQuietPartsRuleOutOrKnowNothingOf) {
  WalkingRows rows;
  rows.walk();
  NoiseModel noise = quiet_noise();
  for (NoiseModel::Walk& walk : noise.walks) walk.log_odds = -10;
  EXPECT_EQ(rows.weigh(noise).coefficient, 0);
  noise = quiet_noise();
  noise.from_quiet_parts = false;
  EXPECT_EQ(rows.weigh(noise).coefficient, 0);
}

}  // namespace
}  // namespace fogcomp::diagnosis
