#include "diagnosis/experiment.hpp"

#include <gtest/gtest.h>

#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

// The model of `basic` and this effect, whose only possible shape is its own.
Rival rival(const model::EffectTerm& effect) {
  return {effect.name,
          {fog::test::natural_term("bias", {}, {0.7}),
           fog::test::natural_term("bias_temperature", {2}, {-4e-4, -3e-5}), effect},
          {effect}};
}

Experiment proposed(const model::EffectTerm& a, const model::EffectTerm& b) {
  noise::NoiseModel noise;
  noise.row_s = 120;
  noise.white_variance = 0.007 * 0.007;
  return propose_experiment(fog::test::truth(), {rival(a), rival(b)}, noise);
}

const model::EffectTerm kRate = fog::test::natural_term("temperature_rate", {}, {0.12});

TEST(Experiment, TellsApartWhatDiffersAndSaysByHowMuch) {
  const Experiment experiment =
      proposed(kRate, fog::test::natural_term("thermal_hysteresis", {5}, {0.03}));
  EXPECT_FALSE(experiment.profile.empty());
  EXPECT_GT(experiment.hours, 1);
  EXPECT_GT(experiment.separation, 3);
  for (const std::string& word :
       {experiment.profile, std::string("temperature_rate"), std::string("thermal_hysteresis")}) {
    EXPECT_NE(experiment.sentence.find(word), std::string::npos) << experiment.sentence;
  }
}

// A warm-up of five hours and ageing that continues: days at one temperature separate them best.
TEST(Experiment, IsTheOneOfTheMenuThatTellsMost) {
  const Experiment experiment = proposed(fog::test::natural_term("aging", {3600}, {0.02}),
                                         fog::test::natural_term("warm_up", {18000}, {-0.05}));
  EXPECT_EQ(experiment.profile, "long_soak") << experiment.sentence;
}

TEST(Experiment, IsNoneForTwoNamesOfTheSame) {
  const Experiment experiment =
      proposed(kRate, fog::test::natural_term("thermal_lag", {5}, {0.12}));
  EXPECT_TRUE(experiment.profile.empty()) << experiment.sentence;
  EXPECT_LT(experiment.separation, 3);
  EXPECT_NE(experiment.sentence.find("thermal_lag"), std::string::npos) << experiment.sentence;
}

}  // namespace
}  // namespace fogcomp::diagnosis
