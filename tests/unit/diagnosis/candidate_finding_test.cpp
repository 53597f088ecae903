#include "diagnosis/candidate_finding.hpp"

#include <gtest/gtest.h>

#include "diagnosis/model_fit.hpp"
#include "unit/diagnosis/made_evidence.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kMissing_dph = 0.5;

// The gyro has a hysteresis that the model lacks.
recording::Recording gyro_with_hysteresis() {
  model::Model gyro = fog::test::truth();
  model::EffectTerm hysteresis = model::parse_effects("thermal_hysteresis:radius=5")[0];
  hysteresis.coefficients_dph = {kMissing_dph / 5};  // per degC of play
  gyro.terms.push_back(hysteresis);
  return fog::test::thinned(fog::test::recording_of(gyro, fog::test::kQuietNoise, 1), 4);
}

class CandidateFindingTest : public testing::Test {
 protected:
  // Ripple first; of hysteresis the second shape is the true one.
  CandidateFindingTest()
      : made_(gyro_with_hysteresis()),
        evidence_(
            made_.evidence({{"polarization_ripple:period=9"},
                            {"thermal_hysteresis:radius=1", "thermal_hysteresis:radius=5"}})) {}
  std::vector<CandidateFinding> find(const judge::Explanations& explanations) const {
    return find_of_candidates(evidence_, explanations, made_.series(), made_.fit());
  }

  fog::test::MadeEvidence made_;
  EvidenceSpace evidence_;
};

// What the judge says of the two effects: the first shape of each, of likelihoods alike.
judge::Explanations explanations_of(std::vector<judge::Explanation> all) {
  judge::Explanations explanations;
  explanations.all = std::move(all);
  explanations.effects = {{0.5, 0.2, 3, {0}, 0, 0.1}, {0.8, 0.7, 9, {0, 0}, 0, 0.6}};
  return explanations;
}

TEST_F(CandidateFindingTest, SaysWhatTheJudgeSays) {
  const CandidateFinding finding = find(explanations_of({}))[1];
  EXPECT_EQ(finding.effect, "thermal_hysteresis");
  EXPECT_EQ(finding.probability, 0.8);
  EXPECT_EQ(finding.lead, 0.7);
  EXPECT_EQ(finding.evidence, 9);
  EXPECT_EQ(finding.explained_fraction, 0.6);
}

// Two parts of one effect, the larger shape first in the set.
TEST(CandidateFinding, OfAnEffectThatStandsTwiceHasBothParts) {
  model::Model gyro = fog::test::truth();
  gyro.terms.push_back(model::parse_effects("thermal_hysteresis:radius=5,radius2=15")[0]);
  gyro.terms.back().coefficients_dph = {0.5, 0.25};
  const fog::test::MadeEvidence made(
      fog::test::thinned(fog::test::recording_of(gyro, fog::test::kQuietNoise, 1), 4));
  const EvidenceSpace evidence =
      made.evidence({{"thermal_hysteresis:radius=5", "thermal_hysteresis:radius=15"}});
  const auto find = [&](std::vector<judge::Part> parts) {
    judge::Explanations explanations;
    explanations.all.push_back({std::move(parts)});
    explanations.effects = {{1, 1, 9, {0, 0}, 0, 1}};
    return find_of_candidates(evidence, explanations, made.series(), made.fit())[0];
  };
  const CandidateFinding both = find({{0, 1}, {0, 0}});
  EXPECT_EQ(both.term().parameters[0].value, 5);
  EXPECT_EQ(both.term().parameters[1].value, 15);
  EXPECT_LT(both.rms_after_dph, 0.5 * find({{0, 0}}).rms_after_dph);
  EXPECT_LT(both.rms_after_dph, 0.5 * find({{0, 1}}).rms_after_dph);
}

// Refitted with it the model equals the gyro: the coefficient, and an rms of noise.
TEST_F(CandidateFindingTest, CompletesTheModel) {
  judge::Explanations explanations = explanations_of({});
  explanations.effects[1].shape = 1;
  const CandidateFinding finding = find(explanations)[1];
  EXPECT_EQ(finding.term().name, "thermal_hysteresis");
  EXPECT_EQ(finding.term().parameters[0].value, 5);
  EXPECT_NEAR(finding.term().coefficients_dph[0].value, kMissing_dph / 5, 0.1 * kMissing_dph / 5);
  EXPECT_NEAR(finding.rms_after_dph, 0.0243, 0.002);
  EXPECT_GT(rms_of_rows(made_.series().rows(), made_.fit(), made_.fit().residual_dph),
            1.2 * finding.rms_after_dph);
}

// Uses the shape in the most probable set that contains the effect, and lists the shapes that are
// about as likely.
TEST_F(CandidateFindingTest, TakesTheShapeOfItsLikeliestSet) {
  judge::Explanations explanations = explanations_of({{{{0, 0}}}, {{{1, 1}}}, {{{1, 0}}}});
  EXPECT_EQ(find(explanations)[1].term().parameters[0].value, 5);
  EXPECT_EQ(find(explanations)[1].possible.size(), 2U);
  explanations.effects[1] = {0.8, 0.7, 9, {-100, 0}, 1, 0.6};
  ASSERT_EQ(find(explanations)[1].possible.size(), 1U);
  EXPECT_EQ(find(explanations)[1].possible[0].parameters[0].value, 5);
}

CandidateFinding finding(const std::string& effect, double lead, double probability,
                         double evidence) {
  CandidateFinding one;
  one.effect = effect;
  one.lead = lead;
  one.probability = probability;
  one.evidence = evidence;
  return one;
}

TEST(SortedByLead, ThenByProbabilityThenByEvidenceAndEqualOnesStay) {
  std::vector<CandidateFinding> findings{
      finding("e", 0.1, 0.2, 1), finding("c", 0.1, 0.2, 7), finding("b", 0.1, 0.3, 0),
      finding("d", 0.1, 0.2, 1 + 1e-12), finding("a", 0.5, 0.5, 0)};
  findings = sorted_by_lead(std::move(findings));
  std::string order;
  for (const CandidateFinding& one : findings) order += one.effect;
  EXPECT_EQ(order, "abced");
}

}  // namespace
}  // namespace fogcomp::diagnosis
