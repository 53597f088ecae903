#include "findings/compare_words.hpp"

#include <gtest/gtest.h>

#include "compare/decision_rules.hpp"

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
  run.analysis.inputs[0].test.score = 2 * compare::rules::kStructured;
  run.analysis.inputs[0].test.variance_dph2 = 0.4;
  EXPECT_EQ(structure_words(run).substr(0, 44), "of what is above the floor: input rate 40 %;");
  run.analysis.excess_dph2 = {};  // at the floor there is nothing to explain
  EXPECT_EQ(structure_words(run), "at the noise floor, yet it depends on input rate");
}

}  // namespace
}  // namespace fogcomp::findings
