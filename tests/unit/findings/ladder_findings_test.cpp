// What is proposed for the model that a selection wrote depends on how it ended, not on its steps.

#include "findings/findings.hpp"

#include <gtest/gtest.h>

#include "findings/json.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::findings {
namespace {

using diagnosis::Verdict;

const DiagnosedFiles kWritten{"old.model", {"run.csv"}, {"other.csv"},
                              {},          "new.model", {"--static", "rest.csv"}};

// Of one step, named or only describing.
diagnosis::Ladder ladder_of(Verdict last, bool is_cut_off, bool describes) {
  diagnosis::Ladder ladder;
  ladder.model = fog::test::truth();
  ladder.steps.emplace_back();
  ladder.steps[0].describes = describes;
  ladder.first.verdict = describes ? Verdict::unknown : Verdict::missing_effect;
  ladder.last.verdict = last;
  ladder.is_cut_off = is_cut_off;
  return ladder;
}

std::string proposed(const diagnosis::Ladder& ladder, const DiagnosedFiles& files = kWritten,
                     const std::vector<model::EffectTerm>& offered = {}) {
  const diagnosis::DiagnosisData data(ladder.model, {}, offered);
  return next_after_ladder(ladder, data, files).command;
}

TEST(NextAfterLadder, IsTheHeaderIfNothingIsMissing) {
  for (const bool describes : {false, true}) {
    for (const bool is_cut_off : {false, true}) {
      EXPECT_EQ(proposed(ladder_of(Verdict::none, is_cut_off, describes)),
                "fogcomp export new.model -o fog_model.h");
    }
  }
}

TEST(NextAfterLadder, IsToGoOnIfOnlyTheLimitEndedIt) {
  for (const bool describes : {false, true}) {
    EXPECT_EQ(proposed(ladder_of(Verdict::unknown, true, describes)),
              "fogcomp diagnose new.model run.csv --holdout other.csv --static rest.csv");
  }
  const std::vector<model::EffectTerm> offered{model::expression_term("burst = T*T*dTdt")};
  diagnosis::Ladder ladder = ladder_of(Verdict::missing_effect, true, false);
  EXPECT_EQ(proposed(ladder, {"old.model", {"run.csv"}, {}, {}, "new.model"}, offered),
            "fogcomp diagnose new.model run.csv --effect-expr 'burst = T*T*dTdt'");
  ladder.model.terms.push_back(offered[0]);  // added by a step
  EXPECT_EQ(proposed(ladder, {"old.model", {"run.csv"}, {}, {}, "new.model"}, offered),
            "fogcomp diagnose new.model run.csv");
}

TEST(NextAfterLadder, IsAComparisonIfWhatIsLeftHasNoName) {
  for (const bool describes : {false, true}) {
    EXPECT_EQ(proposed(ladder_of(Verdict::unknown, false, describes)),
              "fogcomp compare new.model run.csv");
  }
}

TEST(NextAfterLadder, IsTheRecordingThatWouldTell) {
  diagnosis::Ladder ladder = ladder_of(Verdict::ambiguous, false, false);
  ladder.last.experiment = {"reversed", 12, 8, "record `reversed`"};
  const diagnosis::DiagnosisData data(ladder.model, {}, {});
  const Next next = next_after_ladder(ladder, data, kWritten);
  EXPECT_EQ(next.command, "");
  EXPECT_EQ(next.sentence.plain(), "record `reversed`");
}

TEST(NextAfterLadder, IsTheReasonIfNoBoardCanRunTheModel) {
  diagnosis::Ladder ladder = ladder_of(Verdict::none, false, false);
  ladder.model.noise_dph_rthz = 1e5;
  const diagnosis::DiagnosisData data(ladder.model, {}, {});
  const Next next = next_after_ladder(ladder, data, kWritten);
  EXPECT_EQ(next.command, "");
  EXPECT_NE(next.sentence.plain().find("for a board it is not ready"), std::string::npos);
}

TEST(LadderJson, HasTheErrorOfTheHoldoutsOfEachStep) {
  diagnosis::Ladder ladder;
  ladder.steps.emplace_back();
  const auto said = [&] { return ladder_json(ladder, kWritten).text(); };
  EXPECT_NE(said().find("\"holdout_rms_before_dph\":null,\"holdout_rms_after_dph\":null"),
            std::string::npos);
  ladder.steps[0].addition.holdouts = model::HistoryEntry::Holdout{0.5, 0.25};
  EXPECT_NE(said().find("\"holdout_rms_before_dph\":0.5,\"holdout_rms_after_dph\":0.25"),
            std::string::npos);
}

}  // namespace
}  // namespace fogcomp::findings
