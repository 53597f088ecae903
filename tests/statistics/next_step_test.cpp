// The proposal of a diagnosis has been tested: `add` accepts it.
#include "diagnosis/next_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/ladder.hpp"
#include "fit/effect_change.hpp"
#include "statistics/hidden_drift.hpp"
#include "unit/diagnosis/looped.hpp"
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
    for (const recording::Recording& recording : recordings) {
      runs.training.push_back(runs::run_of(recording, {model.average_s}));
    }
    const Ladder one_look = stepwise_selection(model, {model, runs.training}, runs, 0);
    found = one_look.first;
    next = one_look.next;
  }
  // Like the printed command.
  bool add_accepts() const { return try_to_add(model, next.addition->request, runs).accepted; }

  model::Model model;
  runs::Runs runs;
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

// Each power-on has another bias, which shows only once the warm-up is in the model.
TEST(NextStep, IsWhatIsNamedWithABiasOfItsOwnForEachRunWhereOneForAllRefusesIt) {
  const model::EffectTerm hidden = natural_term("warm_up", {900, 0}, {0.8});
  std::vector<recording::Recording> recordings;
  for (const double bias_dph : {0.0, 0.3, -0.25, 0.2}) {
    recordings.push_back(recording_with({hidden}, recordings.size() + 1));
    for (double& rate : recordings.back().rate_dph) rate += bias_dph;
  }
  const Asked asked(kBasic, recordings);
  EXPECT_EQ(asked.found.effect, "warm_up");
  ASSERT_TRUE(asked.next.addition);
  EXPECT_TRUE(asked.next.only_with_own_biases);
  EXPECT_TRUE(asked.next.addition->request.run_offsets);
  EXPECT_EQ(asked.next.addition->request.effects, std::vector<std::string>{"warm_up"});
  EXPECT_TRUE(asked.add_accepts());
}

// A faint kink looks like two effects: the first ends at a bound, the other is judged as a name by
// the other runs.
TEST(NextStep, IsARivalOfTheNameThatIsRefusedWhereOtherRunsJudge) {
  model::EffectTerm kink = written_term("x = max(T-20,0)");
  kink.coefficients_dph = {
      std::ldexp(0.08 * fog::test::kQuietNoise.white_dph, kink.expression->scale_log2)};
  std::vector<recording::Recording> recordings;
  for (const std::uint64_t seed : {1U, 2U, 3U}) recordings.push_back(recording_with({kink}, seed));
  const Asked asked("bias,bias_temperature:order=3,temperature_rate", recordings);
  ASSERT_EQ(asked.found.verdict, Verdict::ambiguous);
  ASSERT_FALSE(asked.next.refused.empty());
  ASSERT_TRUE(asked.next.addition);
  EXPECT_FALSE(asked.next.describes);
  const auto& rivals = asked.found.confusable;
  for (const TriedAddition* one : {&asked.next.refused.front(), &*asked.next.addition}) {
    EXPECT_EQ(std::count(rivals.begin(), rivals.end(), one->request.names()[0]), 1);
  }
  EXPECT_TRUE(asked.add_accepts());
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
    EXPECT_EQ(asked.found.verdict, Verdict::unknown) << form << ": " << asked.found.effect;
    ASSERT_TRUE(asked.next.addition) << form;
    EXPECT_TRUE(asked.next.describes) << form;
    ASSERT_FALSE(asked.next.forms.empty()) << form;
    EXPECT_EQ(asked.next.forms[0].text, form);
    EXPECT_TRUE(asked.add_accepts()) << form;
  }
}

// Whatever its phase: the search begins with two. One of 1.5 times the noise.
TEST(NextStep, IsARippleOverTheTemperatureThatGoesWithItsRate) {
  for (const double phase : {0.0, 0.8, 1.6, 2.4}) {
    model::EffectTerm hidden = written_term(format("x = sin(6.2832*T/44+%g)*dTdt", phase));
    hidden.coefficients_dph = {
        std::ldexp(6 * fog::test::kQuietNoise.white_dph, hidden.expression->scale_log2)};
    const Asked asked(kBasic, {recording_with({hidden}, 1)});
    EXPECT_EQ(asked.found.verdict, Verdict::unknown) << phase;
    ASSERT_FALSE(asked.next.forms.empty()) << phase;
    EXPECT_EQ(asked.next.forms[0].text, "sin(6.2832*T/p+c)*dTdt") << phase;
    EXPECT_TRUE(asked.add_accepts()) << phase;
  }
}

// 5.0 to 5.2 V hardly differ from a bias, but what varies of them is no random walk.
TEST(NextStep, IsASensitivityToASupplyThatHardlyVaries) {
  recording::Recording recording = recording_with({}, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double phase = static_cast<double>(i) / static_cast<double>(recording.rows());
    const double supply_v = 5.1 + 0.1 * std::sin(19 * phase) * std::cos(7 * phase * phase);
    recording[fog::Input::supply].push_back(supply_v);
    recording.rate_dph[i] += 0.6 * supply_v;
  }
  const Asked asked(kBasic, {recording});
  ASSERT_TRUE(asked.next.addition);
  EXPECT_EQ(asked.next.addition->request.expression, "V_itself = V");
  EXPECT_TRUE(asked.add_accepts());
}

// Neither the catalogue nor a formula of its inputs describes a ripple that is denser where it is
// warm.
TEST(NextStep, IsANetworkWhereNothingElseHoldsAndAnotherRunShowsThatItDoes) {
  model::EffectTerm hidden = written_term("x = sin(T^2/300+2)*tanh(4*dTdt)");
  hidden.coefficients_dph = {std::ldexp(0.1, hidden.expression->scale_log2)};
  const recording::Recording first = recording_with({hidden}, 1);
  const Asked of_one(kBasic, {first});
  EXPECT_FALSE(of_one.next.addition) << of_one.next.addition->request.names()[0];

  const Asked of_two(kBasic, {first, recording_with({hidden}, 2)});
  ASSERT_TRUE(of_two.next.addition) << of_two.next.refused.back().reason;
  EXPECT_TRUE(of_two.next.describes);
  EXPECT_TRUE(of_two.next.addition->request.is_network())
      << of_two.next.addition->request.names()[0] << ": " << of_two.next.addition->reason;
  EXPECT_TRUE(of_two.add_accepts());
}

// A ripple is missing beside a larger effect that explains nearly all: no cycle, and the larger
// comes first.
TEST(NextStep, IsTheLargerOfTwoEffectsAlthoughTheSmallerLooksLikeACycleBesideIt) {
  for (const double amplitude_dph : {0.03, 0.04}) {
    const Asked asked(
        "bias,bias_temperature:order=2",
        {recording_with({natural_term("polarization_ripple", {9, 0}, {amplitude_dph, 0})}, 1)});
    EXPECT_EQ(asked.found.fast_kind, FastKind::none) << amplitude_dph;
    ASSERT_TRUE(asked.next.addition) << amplitude_dph;
    EXPECT_FALSE(asked.next.describes) << amplitude_dph;
    EXPECT_TRUE(asked.add_accepts()) << amplitude_dph;
  }
}

// The diagnosis allows for a formula that is not quite the gyro's, so that a chirp is no missing
// effect.
TEST(NextStep, RefinesAFormulaThatIsNotQuiteTheGyros) {
  const auto ripple = [](double chirp) {
    return natural_term("polarization_ripple", {7, 0, chirp}, {0.04, 0.03});
  };
  const Asked asked(std::string(kBasic) + ",polarization_ripple",
                    {recording_with({ripple(0.03)}, 1)});
  ASSERT_TRUE(asked.next.addition);
  const AdditionRequest& request = asked.next.addition->request;
  EXPECT_TRUE(request.refines);
  EXPECT_TRUE(asked.next.describes);
  EXPECT_EQ(request.names(), std::vector<std::string>{"polarization_ripple"});
  EXPECT_LT(asked.next.addition->rms_after_dph, 0.97 * asked.next.addition->rms_before_dph);
  EXPECT_TRUE(asked.add_accepts());
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Asked exact(std::string(kBasic) + ",polarization_ripple",
                      {recording_with({ripple(0)}, seed)});
    EXPECT_FALSE(exact.next.addition) << seed;
  }
}

// Its limit is for effects.
TEST(NextStep, RefinesInALoopThatMayAddNoMore) {
  const recording::Recording recording =
      recording_with({natural_term("polarization_ripple", {7, 0, 0.03}, {0.04, 0.03})}, 1);
  const model::Model model = fog::test::incomplete(kBasic);
  const Ladder ladder = fog::test::looped(model, recording, 1);
  ASSERT_EQ(ladder.steps.size(), 2U);
  EXPECT_TRUE(ladder.is_cut_off);
  EXPECT_FALSE(ladder.steps[0].addition.request.refines);
  EXPECT_TRUE(ladder.steps[1].addition.request.refines);
  EXPECT_LT(ladder.steps[1].addition.fitted_after_dph, ladder.steps[1].addition.fitted_before_dph);
  EXPECT_EQ(ladder.added(), std::vector<std::string>{"polarization_ripple"});
}

// A polynomial of the temperature of a part that is warmed late: nothing of the catalogue, and no
// single formula either.
TEST(NextStep, DescribesPartOfWhatNothingDescribesWhole) {
  model::EffectTerm hidden = written_term("x = lag(T,500)^2+20*lag(T,500)");
  hidden.coefficients_dph = {std::ldexp(3e-4, hidden.expression->scale_log2)};
  const Asked asked("bias,bias_temperature:order=2,temperature_rate",
                    {recording_with({hidden}, 1)});
  ASSERT_NE(asked.found.verdict, Verdict::none);
  ASSERT_TRUE(asked.next.addition);
  const model::HistoryEntry& step = asked.next.addition->model->history.back();
  EXPECT_LT(step.rms_after_dph, 0.9 * step.rms_before_dph);
  EXPECT_TRUE(asked.add_accepts());
}

// The bias of a gyro is another after each power-on: it says nothing for or against an effect.
TEST(NextStep, IsJudgedWithABiasOfItsOwnForEachRun) {
  const model::EffectTerm ripple = natural_term("polarization_ripple", {9, 0}, {0.03, 0});
  std::vector<recording::Recording> recordings;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    recordings.push_back(recording_with({ripple}, seed));
    for (double& rate_dph : recordings.back().rate_dph) {
      rate_dph += 0.15 * static_cast<double>(seed);
    }
  }
  const model::Model model = fog::test::incomplete(kBasic);
  runs::Runs runs;
  for (const recording::Recording& recording : recordings) {
    runs.training.push_back(runs::run_of(recording, {model.average_s}));
  }
  const DiagnosisData data(model, runs.training);
  DiagnosisSettings settings;
  settings.run_offsets = true;
  const Diagnosis found = diagnose(model, data, settings);
  AdditionJudge judge(model, runs, settings.run_offsets);
  const NextStep next = find_next_step(model, found, data, judge, settings);
  ASSERT_TRUE(next.addition) << next.refused.back().reason;
  EXPECT_EQ(next.addition->request.effects, std::vector<std::string>{"polarization_ripple"});
  EXPECT_TRUE(next.addition->request.run_offsets);
  EXPECT_LT(next.addition->rms_after_dph, 1.1 * fog::test::kQuietNoise.white_dph);
  EXPECT_NE(next.addition->reason.find("3 runs, each left out once"), std::string::npos)
      << next.addition->reason;
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
