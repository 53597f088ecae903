#include "findings/diagnosis_words.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"

namespace fogcomp::findings {
namespace {

TEST(DiagnosisWords, OfASetSayWhyThereIsNoCommandToType) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::missing_effect;
  diagnosis.effect = "aging";
  diagnosis.residual_rms_dph = 907.1;
  CandidateFinding aging;
  aging.effect = "aging";
  aging.completed = parse_effects("bias,aging");
  aging.rms_after_dph = 907.4;  // alone it does not lower the error
  diagnosis.candidates.push_back(aging);
  diagnosis.explanations.push_back({{"thermal_lag", "aging"}, 0.83, 0.96});
  const DiagnosisWords words = words_of(diagnosis, "x.model", "run.csv");
  EXPECT_EQ(words.verdict, "several effects together are missing: thermal_lag and aging");
  EXPECT_EQ(words.command, "");
  EXPECT_EQ(words.next,
            "fit again with thermal_lag and aging among the --effects: `add` takes one effect at a "
            "time, which hardly helps");
}

}  // namespace
}  // namespace fogcomp::findings
