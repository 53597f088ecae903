#include "diagnosis/ladder.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

using Names = std::vector<std::string>;

Ladder::Step step(const std::string& effect, bool removed = false) {
  Ladder::Step one;
  one.effect = effect;
  one.removed = removed;
  return one;
}

TEST(Ladder, ListsWhatItAddedAndKeptOnceEach) {
  Ladder ladder;
  EXPECT_TRUE(ladder.added().empty());
  ladder.steps = {step("aging"),
                  step("shupe"),
                  step("bias_temperature"),
                  step("aging", true),
                  step("bias_temperature"),
                  step("aging")};
  EXPECT_EQ(ladder.added(), (Names{"shupe", "bias_temperature", "aging"}));
}

// A rate term is missing.
TEST(Ladder, AddsNoMoreThanItMayAndSaysWhatAStepBrought) {
  model::Model model = fog::test::truth();
  const recording::Recording recording =
      fog::test::thinned(fog::test::recording_of(model, fog::test::kQuietNoise, 1), 3);
  model.terms = model::parse_effects("bias,bias_temperature:order=3");
  DiagnosisData data(model);
  data.add(recording);
  double progress = 0;
  DiagnosisSettings settings;
  settings.progress = [&](double done) {
    EXPECT_GE(done, progress);
    EXPECT_LE(done, 1);
    progress = done;
  };
  const Ladder ladder = walk_ladder(model, data, 1, settings);
  ASSERT_EQ(ladder.steps.size(), 1U);
  const Ladder::Step& step = ladder.steps[0];
  EXPECT_EQ(step.effect, effect_to_add(ladder.first));
  EXPECT_FALSE(step.removed);
  EXPECT_EQ(step.rms_before_dph, ladder.first.residual_rms_dph);
  EXPECT_EQ(step.rms_after_dph, ladder.last.residual_rms_dph);
  EXPECT_LT(step.rms_after_dph, 0.5 * step.rms_before_dph);
  ASSERT_EQ(ladder.terms.size(), 3U);
  EXPECT_EQ(ladder.terms.back().name, step.effect);
}

}  // namespace
}  // namespace fogcomp::diagnosis
