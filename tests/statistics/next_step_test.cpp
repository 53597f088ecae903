// The proposal of a diagnosis has been tested: `add` accepts it.
#include "diagnosis/next_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/effect_change.hpp"
#include "statistics/hidden_drift.hpp"
#include "unit/fit/simulated_addition.hpp"

namespace fogcomp::diagnosis {
namespace {

using fog::test::kBasic;
using fog::test::natural_term;
using fog::test::recording_with;
using fog::test::written_term;

// The next step for a model of `effects` on recordings of one noise.
struct Asked {
  Asked(const std::string& effects, const std::vector<recording::Recording>& recordings)
      : model(fog::test::incomplete(effects)) {
    fit::TrainingRuns& training = runs.training;
    DiagnosisData data(model);
    for (const recording::Recording& recording : recordings) {
      training.runs.push_back(compare::run_in_blocks(recording, model.average_s));
      data.add(training.runs.back());
    }
    training.noise_floor_dph = training.runs[0].noise_floor_dph;
    found = diagnose(model, data);
    next = find_next_step(model, found, data, runs);
  }
  // Like the printed command.
  bool add_accepts() const { return try_to_add(model, next.addition->request, runs).accepted; }

  model::Model model;
  JudgingRuns runs;
  Diagnosis found;
  NextStep next;
};

TEST(NextStep, IsTheEffectThatIsNamed) {
  const Asked asked("bias,bias_temperature:order=2", {recording_with({}, 1)});
  ASSERT_TRUE(asked.next.addition);
  EXPECT_FALSE(asked.next.describes);
  EXPECT_EQ(asked.next.addition->request.effects, std::vector<std::string>{"temperature_rate"});
  EXPECT_TRUE(asked.add_accepts());
}

TEST(NextStep, IsNothingWhereNothingIsMissing) {
  const Asked asked(kBasic, {recording_with({}, 1)});
  EXPECT_EQ(asked.found.verdict, Verdict::none);
  EXPECT_FALSE(asked.next.addition);
  EXPECT_TRUE(asked.next.refused.empty());
}

// Effects outside the catalogue, of 1.5 times the noise.
TEST(NextStep, IsTheFormOfWhatTheCatalogueLacks) {
  const struct {
    const char* form;
    double typical;  // of the formula on this programme
  } kHidden[] = {{"dTdt^2", 0.3}, {"abs(dTdt)", 0.35}, {"T^2*dTdt", 400}, {"T*dTdt^2", 10}};
  for (const auto& [form, typical] : kHidden) {
    model::EffectTerm hidden = written_term(std::string("x = ") + form);
    hidden.coefficients_dph = {std::ldexp(1.5 * fog::test::kQuietNoise.white_dph / typical,
                                          hidden.expression->scale_log2)};
    const Asked asked(kBasic, {recording_with({hidden}, 1)});
    EXPECT_EQ(asked.found.verdict, Verdict::unknown) << form;
    ASSERT_TRUE(asked.next.addition) << form;
    EXPECT_TRUE(asked.next.describes) << form;
    ASSERT_FALSE(asked.next.forms.empty()) << form;
    EXPECT_EQ(asked.next.forms[0].text, form);
    EXPECT_TRUE(asked.add_accepts()) << form;
  }
}

// Neither the catalogue nor a formula of its inputs describes this.
TEST(NextStep, IsANetworkWhereNothingElseHoldsAndAnotherRunShowsThatItDoes) {
  model::EffectTerm hidden = written_term("x = sin(T/6)*tanh(4*dTdt)");
  hidden.coefficients_dph = {std::ldexp(0.1, hidden.expression->scale_log2)};
  const recording::Recording first = recording_with({hidden}, 1);
  const Asked of_one(kBasic, {first});
  EXPECT_FALSE(of_one.next.addition) << of_one.next.addition->request.names()[0];
  EXPECT_FALSE(of_one.next.refused.empty());

  const Asked of_two(kBasic, {first, recording_with({hidden}, 2)});
  ASSERT_TRUE(of_two.next.addition) << of_two.next.refused.back().reason;
  EXPECT_TRUE(of_two.next.describes);
  EXPECT_TRUE(of_two.next.addition->request.is_network())
      << of_two.next.addition->request.names()[0] << ": " << of_two.next.addition->reason;
  EXPECT_TRUE(of_two.add_accepts());
}

// In one of two runs only: cross-validation within it shows the formula, the other run does not.
TEST(NextStep, IsNoDescriptionThatAnotherRunContradicts) {
  model::EffectTerm hidden = written_term("x = abs(dTdt)");
  hidden.coefficients_dph = {std::ldexp(0.2, hidden.expression->scale_log2)};
  const Asked asked(kBasic, {recording_with({hidden}, 1), recording_with({}, 2)});
  EXPECT_FALSE(asked.next.addition) << asked.next.addition->request.names()[0];
  const auto& refused = asked.next.refused;
  EXPECT_TRUE(std::any_of(refused.begin(), refused.end(), [](const TriedAddition& trial) {
    return trial.reason.find("when that run is left out") != std::string::npos;
  }));
}

}  // namespace
}  // namespace fogcomp::diagnosis
