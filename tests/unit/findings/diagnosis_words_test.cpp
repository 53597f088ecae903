#include "findings/diagnosis_words.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"

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

TEST(DiagnosisWords, OfASetAddAllOfIt) {
  const DiagnosisWords words = words_of(only_together(), "x.model", "run.csv");
  EXPECT_EQ(words.verdict, "several effects together are missing: thermal_lag and aging");
  EXPECT_EQ(words.command, "fogcomp add x.model thermal_lag aging run.csv -o NEW.model");
}

TEST(DiagnosisWords, OfRivalsThatDoNotHelpAloneProposeTheSetThatDoes) {
  diagnosis::Diagnosis diagnosis = only_together();
  diagnosis.verdict = diagnosis::Verdict::ambiguous;
  diagnosis.effect.clear();
  diagnosis.confusable = {"aging"};
  EXPECT_EQ(words_of(diagnosis, "x.model", "run.csv").command,
            "fogcomp add x.model thermal_lag aging run.csv -o NEW.model");
  diagnosis.explanations[0].effects = {"aging", "aging"};  // twice the same cannot be added so
  EXPECT_EQ(words_of(diagnosis, "x.model", "run.csv").command, "");
}

TEST(DiagnosisWords, ASetWithAStepIsFittedAgain) {
  diagnosis::Diagnosis diagnosis = only_together();
  diagnosis.candidates.push_back(finding_of("bias_step", 0.1, 905));
  diagnosis.explanations[0].effects = {"aging", "bias_step"};
  const DiagnosisWords words = words_of(diagnosis, "x.model", "run.csv");
  EXPECT_EQ(words.command, "");
  EXPECT_EQ(
      words.next,
      "fit again with aging and bias_step among the --effects: it finds steps and masks them");
}

}  // namespace
}  // namespace fogcomp::findings
