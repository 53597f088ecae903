#include "findings/compare_words.hpp"

#include <gtest/gtest.h>

#include "compare/decision_rules.hpp"
#include "support/evidence.hpp"

namespace fogcomp::findings {
namespace {

TEST(StructureWords, NameTheInputsOnWhichNothingDependsAndWhatGoesWithTheInputRate) {
  compare::ModelOnRun run;
  run.comparison.outlier.resize(compare::rules::kMinRowsToJudge);
  EXPECT_EQ(structure_words(run),
            "nothing in it depends on temperature, temperature rate, time or history beyond noise");
  run.comparison.inputs.push_back({fog::Input::input_rate, {}});
  run.analysis.inputs.emplace_back();
  run.analysis.excess_dph2 = 1;
  run.analysis.input_rate_share = 0.98;
  EXPECT_EQ(
      structure_words(run),
      "nothing in it depends on temperature, temperature rate, time, history or input rate "
      "alone beyond noise; errors that go with the input rate, its change or its product with "
      "temperature explain 98 % of its variance");
  run.analysis.inputs[0].test.score = 2 * kCertainSigmas;
  run.analysis.inputs[0].test.variance_dph2 = 0.4;
  EXPECT_EQ(structure_words(run).substr(0, 44), "of what is above the floor: input rate 40 %;");
  run.analysis.excess_dph2 = {};  // at the floor there is nothing to explain
  EXPECT_EQ(structure_words(run), "at the noise floor, yet it depends on input rate");
}

TEST(TurnOnSentences, NameABiasThatIsCertainAndElseWhatWouldTell) {
  compare::TurnOn turn_on;
  turn_on.biases.push_back({"second.csv", 0, "first.csv", -0.12, 0.01, true});
  turn_on.biases.push_back({"third.csv", 0, "first.csv", 0.02, 0.01, false});
  turn_on.repeatability_dph = 0.08;
  turn_on.differs = true;
  std::vector<Text> said = turn_on_sentences(turn_on);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].plain().find("turn-on bias: second.csv is 0.12"), 0U) << said[0].plain();
  EXPECT_NE(said[0].plain().find("deg/h below first.csv"), std::string::npos) << said[0].plain();

  turn_on.biases[0].certain = false;
  said = turn_on_sentences(turn_on);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].plain().find("differs by 0.08 deg/h (one sigma)"), std::string::npos);
  EXPECT_NE(said[0].plain().find("would tell"), std::string::npos);

  turn_on.differs = false;
  EXPECT_TRUE(turn_on_sentences(turn_on).empty());
}

}  // namespace
}  // namespace fogcomp::findings
