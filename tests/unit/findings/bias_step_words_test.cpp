// Which bias a board will have is said in the same words wherever a bias step is found.

#include "findings/bias_step_words.hpp"

#include <gtest/gtest.h>

#include "findings/json.hpp"
#include "model/effect_list.hpp"

namespace fogcomp::findings {
namespace {

// As a fit leaves a step: at 25995 s, of 0.3 deg/h.
model::EffectTerm found_step(double others_part) {
  model::EffectTerm step = model::parse_effects("bias_step")[0];
  step.parameters = {{25995, 2.9, true}};
  step.coefficients_dph = {{0.3, 0.0049}};
  step.recording = 7;
  step.others_part = others_part;
  return step;
}

TEST(BiasStepWords, SayWhoseBiasTheModelHas) {
  EXPECT_EQ(bias_step_words(found_step(1), "run.csv, soak 20").plain(),
            "bias step of +0.3000 +- 0.0049 deg/h at 25995 +- 2.9 s (run.csv, soak 20); the "
            "model's bias is that after it");
  EXPECT_EQ(bias_step_words(found_step(0)).plain(),
            "bias step of +0.3000 +- 0.0049 deg/h at 25995 +- 2.9 s; the model's bias is that "
            "before it");
  EXPECT_EQ(bias_step_words(found_step(0.4)).plain(),
            "bias step of +0.3000 +- 0.0049 deg/h at 25995 +- 2.9 s; the model's bias is the mean "
            "of this recording, because there are several");
}

TEST(BiasStepWords, AreOfFoundStepsOnly) {
  model::Model model;
  model.terms = model::parse_effects("bias,bias_step:at=3600");
  model.terms[1].coefficients_dph = {0.1};
  EXPECT_TRUE(found_steps(model).empty());
  model.terms.push_back(model::parse_effects("bias_step")[0]);  // sought, not yet found
  EXPECT_TRUE(found_steps(model).empty());
  model.terms.push_back(found_step(1));
  ASSERT_EQ(found_steps(model).size(), 1U);
  EXPECT_EQ(found_steps(model)[0].parameters[0].value, 25995);
}

TEST(BiasStepWords, AreValuesOfTheLadder) {
  diagnosis::Ladder ladder;
  ladder.model.terms = model::parse_effects("bias");
  ladder.model.terms.push_back(found_step(1));
  const std::string json = ladder_json(ladder, {"x.model", {"run.csv"}}).text();
  EXPECT_NE(json.find("\"bias_steps\":[{\"place\":null,\"time_s\":25995,\"time_sigma_s\":2.9,"
                      "\"size_dph\":0.3,\"size_sigma_dph\":0.0049,\"model_bias\":\"after\"}]"),
            std::string::npos)
      << json;
}

}  // namespace
}  // namespace fogcomp::findings
