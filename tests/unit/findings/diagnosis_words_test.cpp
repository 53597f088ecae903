#include "findings/diagnosis_words.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "findings/json.hpp"
#include "model/effect_list.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

diagnosis::CandidateFinding finding_of(const char* effect, double lead, double rms_after_dph) {
  diagnosis::CandidateFinding finding;
  finding.effect = effect;
  finding.completed = model::parse_effects(std::string("bias,") + effect);
  finding.lead = lead;
  finding.rms_after_dph = rms_after_dph;
  return finding;
}

// Neither of two effects lowers the error alone; both together do.
diagnosis::Diagnosis only_together() {
  diagnosis::Diagnosis diagnosis;
  diagnosis.verdict = diagnosis::Verdict::missing_effect;
  diagnosis.effect = "aging";
  diagnosis.residual_rms_dph = 907.1;
  diagnosis.candidates = {finding_of("aging", 0.66, 907.4), finding_of("thermal_lag", 0.02, 910)};
  diagnosis.explanations.push_back({{"thermal_lag", "aging"}, 0.83, 0.96});
  return diagnosis;
}

const DiagnosedFiles kFiles{"x.model", {"run.csv"}};

diagnosis::TriedAddition tried(const std::vector<std::string>& effects,
                               const std::string& expression = "") {
  diagnosis::TriedAddition addition;
  addition.request = {effects, expression};
  addition.reason = "gain 3.1, needed 10";
  return addition;
}

TEST(DiagnosisWords, OfASetAddAllOfIt) {
  diagnosis::NextStep next;
  next.addition = tried({"thermal_lag", "aging"});
  next.together = {"thermal_lag", "aging"};
  const DiagnosisWords words = words_of(only_together(), next, kFiles);
  EXPECT_EQ(words.verdict, "several effects together are missing: thermal_lag and aging");
  EXPECT_EQ(words.command, "fogcomp add x.model thermal_lag aging run.csv -o NEW.model");
}

TEST(DiagnosisWords, OfAnImprobableSetSayMayBe) {
  diagnosis::NextStep next;
  next.addition = tried({"thermal_lag", "aging"});
  next.together = {"thermal_lag", "aging"};
  diagnosis::Diagnosis found = only_together();
  found.explanations[0].probability = 0.21;
  EXPECT_EQ(words_of(found, next, kFiles).verdict,
            "several effects together may be missing: thermal_lag and aging");
}

TEST(DiagnosisWords, OfSomethingFaintNameNothing) {
  diagnosis::Diagnosis found = only_together();
  found.verdict = diagnosis::Verdict::unknown;
  found.nothing = 0.4;
  found.noise_floor_dph = found.residual_rms_dph;
  EXPECT_EQ(words_of(found, {}, kFiles).verdict, "something may be missing, too faint to be named");
  found.residual_rms_dph = 2 * found.noise_floor_dph;
  EXPECT_EQ(words_of(found, {}, kFiles).verdict, "slow changes are left, which may be noise");
}

TEST(DiagnosisWords, OfAWithdrawnNameSayWhatItLookedLike) {
  diagnosis::Diagnosis found = only_together();
  found = without_name(std::move(found));
  EXPECT_EQ(found.verdict, diagnosis::Verdict::unknown);
  EXPECT_EQ(found.effect, "");
  EXPECT_EQ(words_of(found, {}, kFiles).verdict,
            "something is missing: what looks like aging does not hold out of sample");
}

TEST(DiagnosisWords, OfAFormulaInSlowNoiseSaySo) {
  diagnosis::Diagnosis found = only_together();
  found.verdict = diagnosis::Verdict::none;
  found = shown_by_formulas(std::move(found), 1e-9);
  EXPECT_EQ(found.verdict, diagnosis::Verdict::unknown);
  EXPECT_EQ(found.nothing, 1e-9);
  EXPECT_EQ(words_of(found, {}, kFiles).verdict,
            "something is missing: what looks like slow noise follows a formula outside the "
            "catalogue");
}

TEST(DiagnosisWords, AddWithABiasForEachRunWhereItWasJudgedSo) {
  diagnosis::NextStep next;
  next.addition = tried({"aging"});
  next.addition->request.run_offsets = true;
  EXPECT_EQ(words_of(only_together(), next, kFiles).command,
            "fogcomp add x.model aging run.csv --run-offsets -o NEW.model");
}

TEST(DiagnosisWords, InBriefAreOneSentenceWithEffectSizeAndProbability) {
  diagnosis::Diagnosis found = only_together();
  found.noise_floor_dph = 9.7;
  diagnosis::NextStep next;
  next.together = {"thermal_lag", "aging"};
  BriefDiagnosis brief = in_brief(found, next);
  EXPECT_EQ(brief.sentence,
            "thermal_lag and aging are missing together: 907.0 deg/h rms, probability 0.83");
  EXPECT_EQ(brief.effects, next.together);

  found.candidates = {finding_of("aging", 0.66, 400)};
  found.candidates[0].probability = 0.97;
  brief = in_brief(found, {});
  EXPECT_EQ(brief.sentence, "aging is missing: 814.1 deg/h rms, probability 0.97");
  EXPECT_NEAR(brief.size_dph, std::sqrt(907.1 * 907.1 - 400 * 400), 1e-9);
  found.terms = model::parse_effects("bias,aging");
  EXPECT_EQ(in_brief(found, {}).sentence,
            "the model's aging is incomplete: 814.1 deg/h rms, probability 0.97");

  found.effect.clear();
  found.verdict = diagnosis::Verdict::ambiguous;
  found.confusable = {"aging", "warm_up"};
  brief = in_brief(found, {});
  EXPECT_EQ(brief.sentence,
            "aging or warm_up is missing, these recordings cannot tell which: 907.0 deg/h rms");
  EXPECT_FALSE(brief.probability);

  found.confusable.clear();
  found.verdict = diagnosis::Verdict::unknown;
  found.variable = "input_rate_dph";
  EXPECT_EQ(in_brief(found, {}).sentence,
            "something is missing that no effect of the catalogue explains (it depends most on "
            "input rate): 907.0 deg/h rms");
  found.verdict = diagnosis::Verdict::none;
  EXPECT_EQ(in_brief(found, {}).sentence,
            "no effect is missing: 907.1 deg/h rms is left, noise alone is 9.700");
}

TEST(DiagnosisWords, SayOfADescriptionThatItIsNoCause) {
  diagnosis::Diagnosis diagnosis = only_together();
  diagnosis.verdict = diagnosis::Verdict::unknown;
  diagnosis.effect.clear();
  diagnosis::NextStep next;
  next.describes = true;
  using diagnosis::FormMeaning;
  next.forms = {{"dTdt^2", "square = dTdt^2", FormMeaning::squared_rate, 0.86},
                {"lag(dTdt^2,tau)", "late = lag(dTdt^2,?tau[60,6000])", FormMeaning::late, 0.14}};
  next.addition = tried({}, "dTdt_squared = dTdt^2");
  const DiagnosisWords words = words_of(diagnosis, next, kFiles);
  const std::string all = join(words.findings, "\n");
  EXPECT_NE(all.find("looks like dTdt^2 (0.86), rather than lag(dTdt^2,tau) (0.14)"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("which physics gives such a form: stress that a gradient"), std::string::npos)
      << all;
  EXPECT_NE(all.find("this describes it, it does not say what it is"), std::string::npos) << all;
  EXPECT_NE(all.find("a run of another programme"), std::string::npos) << all;
  EXPECT_EQ(words.command,
            "fogcomp add x.model run.csv --effect-expr 'dTdt_squared = dTdt^2' -o NEW.model");
}

TEST(DiagnosisWords, SayThatTheBiasChangesFromOnePowerOnToTheNext) {
  diagnosis::NextStep next;
  next.addition = tried({"warm_up"});
  next.addition->request.run_offsets = true;
  next.only_with_own_biases = true;
  diagnosis::Diagnosis diagnosis = only_together();
  diagnosis.verdict = diagnosis::Verdict::missing_effect;
  const DiagnosisWords words = words_of(diagnosis, next, kFiles);
  EXPECT_EQ(words.command, "fogcomp add x.model warm_up run.csv --run-offsets -o NEW.model");
  EXPECT_NE(join(words.limits, "\n").find("warm_up with a bias of its own for each power-on holds"),
            std::string::npos);
}

TEST(DiagnosisWords, SayThatAnEffectShowsBetweenRecordingsOnly) {
  diagnosis::NextStep next;
  next.addition = tried({"bias_temperature"});
  next.only_between_recordings = true;
  diagnosis::Diagnosis diagnosis = only_together();
  diagnosis.verdict = diagnosis::Verdict::missing_effect;
  const DiagnosisWords words = words_of(diagnosis, next, kFiles);
  EXPECT_EQ(words.command, "fogcomp add x.model bias_temperature run.csv -o NEW.model");
  EXPECT_NE(join(words.limits, "\n").find("bias_temperature shows between the recordings"),
            std::string::npos);
}

// Another programme would have another first heat: only a repetition tells.
TEST(DiagnosisWords, AskForTheSameProgrammeAgainAfterAFirstHeat) {
  diagnosis::Diagnosis diagnosis = only_together();
  diagnosis.verdict = diagnosis::Verdict::unknown;
  diagnosis.effect.clear();
  diagnosis::NextStep next;
  next.describes = true;
  next.forms = {{"highest(T)", "T_highest = highest(T)", diagnosis::FormMeaning::first_heat, 1}};
  next.addition = tried({}, "T_highest = highest(T)");
  const std::string all = join(words_of(diagnosis, next, kFiles).findings, "\n");
  EXPECT_NE(all.find("the same programme once more would tell"), std::string::npos) << all;
  EXPECT_EQ(all.find("a run of another programme"), std::string::npos) << all;
}

// Nothing is missing, and yet there is something to do.
TEST(DiagnosisWords, SayWhatCanBeRefined) {
  diagnosis::Diagnosis found = only_together();
  found.verdict = diagnosis::Verdict::none;
  found.effect.clear();
  diagnosis::NextStep next;
  EXPECT_NE(words_of(found, next, kFiles).verdict.find("nothing is missing"), std::string::npos);
  next.describes = true;
  next.addition = tried({"polarization_ripple:chirp=?"});
  next.addition->request.refines = true;
  const DiagnosisWords words = words_of(found, next, kFiles);
  EXPECT_EQ(words.verdict, "no effect is missing, but polarization_ripple can be refined");
  EXPECT_NE(join(words.findings, "\n").find("a part of its formula that the model leaves out"),
            std::string::npos);
  EXPECT_EQ(words.command,
            "fogcomp add x.model 'polarization_ripple:chirp=?' run.csv -o NEW.model");
  const std::string json = diagnosis_json(found, next, kFiles).text();
  EXPECT_NE(json.find("\"description\":{\"kind\":\"refinement\","), std::string::npos) << json;
  EXPECT_NE(json.find("\"verdict\":\"none\""), std::string::npos) << json;
}

TEST(DiagnosisWords, SayWhyNothingCanBeAdded) {
  diagnosis::NextStep next;
  next.describes = true;
  next.refused = {tried({"aging"}), tried({"shupe", "warm_up"}), tried({"warm_up"})};
  const DiagnosisWords words = words_of(only_together(), next, kFiles);
  EXPECT_EQ(words.command, "");
  EXPECT_EQ(words.next,
            "nothing to add: aging was tried and refused, gain 3.1, needed 10; so were: shupe and "
            "warm_up; warm_up");
  EXPECT_NE(
      diagnosis_json(only_together(), next, kFiles)
          .text()
          .find("{\"effects\":[\"shupe\",\"warm_up\"],\"expression\":null,\"reason\":\"gain 3.1, "),
      std::string::npos);
}

TEST(DiagnosisWords, SayWhyTheNamedEffectIsNotWhatIsAdded) {
  diagnosis::NextStep next;
  next.describes = true;
  next.refused = {tried({"aging"})};
  next.addition = tried({"shupe"});
  const std::string said = words_of(only_together(), next, kFiles).certainty;
  EXPECT_NE(said.find("; aging was tried and refused, gain 3.1, needed 10"), std::string::npos)
      << said;
}

TEST(DiagnosisWords, SayWhatWouldShowWhatTheseRecordingsCannot) {
  diagnosis::Diagnosis diagnosis;
  EXPECT_EQ(words_of(diagnosis, {}, kFiles).verdict.find("nothing is missing: "), 0U);
  diagnosis.blind_spot = "a recording at rest would show it";
  const DiagnosisWords words = words_of(diagnosis, {}, kFiles);
  EXPECT_EQ(words.verdict, "nothing is missing that these recordings can show");
  EXPECT_EQ(words.certainty,
            "nothing missing 1.00; outside the catalogue 0.00; " + diagnosis.blind_spot);
}

TEST(DiagnosisWords, CyclesAreLeft_NothingElseMayBeMissing) {
  diagnosis::Diagnosis diagnosis;
  diagnosis.verdict = diagnosis::Verdict::unknown;
  diagnosis.fast_kind = diagnosis::FastKind::line;
  diagnosis.fast.line_period_s = 47;
  const DiagnosisWords words = words_of(diagnosis, {}, kFiles);
  EXPECT_NE(words.verdict.find("cycles"), std::string::npos) << words.verdict;
  EXPECT_EQ(words.certainty.find("nothing else missing 1.00; "), 0U) << words.certainty;
}

// Each command uses the file written by the one before.
TEST(DiagnosisWords, OfALadderAreTheCommandsThatMakeItsModel) {
  diagnosis::Ladder ladder;
  diagnosis::TriedAddition cut = tried({});
  cut.request.cuts = {{"b.csv", 3600}};
  ladder.steps = {{cut, false, {}}, {tried({}, "q = T^2"), true, {}}};
  const DiagnosedFiles files{
      "my gyro.model", {"a.csv", "b.csv"}, {"c.csv"}, {"--rate", "100"}, "best.model"};
  EXPECT_EQ(ladder_commands(ladder, files),
            (std::vector<std::string>{
                "fogcomp add 'my gyro.model' a.csv b.csv --holdout c.csv --rate 100 --cut "
                "b.csv:3600 -o best.model",
                "fogcomp add best.model a.csv b.csv --effect-expr 'q = T^2' --holdout c.csv --rate "
                "100 --cut b.csv:3600 -o best.model"}));
}

}  // namespace
}  // namespace fogcomp::findings
