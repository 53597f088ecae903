#include "diagnosis/candidate_finding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/decision_rules.hpp"
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

Hypothesis hypothesis(std::vector<Hypothesis::Part> parts, double probability) {
  Hypothesis one;
  one.parts = std::move(parts);
  one.probability = probability;
  return one;
}

class CandidateFindingTest : public testing::Test {
 protected:
  // Ripple first; of hysteresis the second shape is the true one.
  CandidateFindingTest()
      : made_(gyro_with_hysteresis()),
        evidence_(
            made_.evidence({{"polarization_ripple:period=9"},
                            {"thermal_hysteresis:radius=1", "thermal_hysteresis:radius=5"}})) {}
  std::vector<CandidateFinding> find(const std::vector<Hypothesis>& hypotheses,
                                     double excess) const {
    return find_of_candidates(evidence_, hypotheses, excess, made_.series(), made_.fit());
  }
  double chi2_drop() const { return evidence_.space.chi2_drop({evidence_.regressors[1][1]}); }

  fog::test::MadeEvidence made_;
  EvidenceSpace evidence_;
};

// Alone in one set, largest in another, not in the third.
TEST_F(CandidateFindingTest, ProbabilitiesAreSumsOverTheSetsThatHaveIt) {
  const auto findings = find(
      {hypothesis({{1, 1}}, 0.5), hypothesis({{0, 0}, {1, 1}}, 0.3), hypothesis({{0, 0}}, 0.2)},
      chi2_drop());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[1].effect, "thermal_hysteresis");
  EXPECT_DOUBLE_EQ(findings[1].probability, 0.8);
  EXPECT_DOUBLE_EQ(findings[1].lead, 0.8);
  EXPECT_DOUBLE_EQ(findings[0].probability, 0.5);
  EXPECT_DOUBLE_EQ(findings[0].lead, 0.2);
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
  const auto find = [&](std::vector<Hypothesis::Part> parts) {
    return find_of_candidates(evidence, {hypothesis(std::move(parts), 1)}, 1, made.series(),
                              made.fit())[0];
  };
  const CandidateFinding both = find({{0, 1}, {0, 0}});
  EXPECT_EQ(both.term().parameters[0].value, 5);
  EXPECT_EQ(both.term().parameters[1].value, 15);
  EXPECT_LT(both.rms_after_dph, 0.5 * find({{0, 0}}).rms_after_dph);
  EXPECT_LT(both.rms_after_dph, 0.5 * find({{0, 1}}).rms_after_dph);
}

TEST_F(CandidateFindingTest, ExplainsItsGainLessWhatItsColumnsWouldByChance) {
  const double own = chi2_drop() - 1;
  EXPECT_NEAR(find({}, own)[1].explained_fraction, 1, 1e-9);
  EXPECT_NEAR(find({}, 2 * own)[1].explained_fraction, 0.5, 1e-9);
  EXPECT_EQ(find({}, own / 2)[1].explained_fraction, 1);
  EXPECT_EQ(find({}, 0)[1].explained_fraction, 0);
}

// Refitted with it the model equals the gyro: the coefficient, and an rms of noise.
TEST_F(CandidateFindingTest, CompletesTheModel) {
  const CandidateFinding finding = find({}, chi2_drop())[1];
  EXPECT_EQ(finding.term().name, "thermal_hysteresis");
  EXPECT_EQ(finding.term().parameters[0].value, 5);
  EXPECT_NEAR(finding.term().coefficients_dph[0].value, kMissing_dph / 5, 0.1 * kMissing_dph / 5);
  EXPECT_NEAR(finding.rms_after_dph, 0.0243, 0.002);
  EXPECT_GT(rms_of_rows(made_.series().rows(), made_.fit(), made_.fit().residual_dph),
            1.2 * finding.rms_after_dph);
}

// Uses the shape in the most probable set that contains the effect, and lists the shapes that
// explain about as much.
TEST_F(CandidateFindingTest, TakesTheShapeOfItsLikeliestSet) {
  const CandidateFinding finding =
      find({hypothesis({{1, 0}}, 0.6), hypothesis({{1, 1}}, 0.4)}, chi2_drop())[1];
  EXPECT_EQ(finding.term().parameters[0].value, 1);
  ASSERT_EQ(finding.possible.size(), 2U);
  EXPECT_EQ(finding.possible[1].parameters[0].value, 5);
  EXPECT_EQ(find({}, chi2_drop())[1].possible.size(), 1U);
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

TEST(BelieveLess, AsFarAsItsEvidenceGoesAndNoWalkExplainsIt) {
  const double odds = rules::kBelievedOdds;
  std::vector<CandidateFinding> findings{finding("half", 0.6, 0.8, std::log(odds / 2)),
                                         finding("sure", 0.4, 0.5, std::log(100 * odds))};
  limit_to_own_evidence(findings, 0.25);
  EXPECT_NEAR(findings[0].probability, 0.8 * 0.5 * 0.75, 1e-12);
  EXPECT_NEAR(findings[0].lead, 0.6 * 0.5 * 0.75, 1e-12);
  EXPECT_NEAR(findings[1].probability, 0.5 * 0.75, 1e-12);
}

TEST(SortByLead, ThenByProbabilityThenByEvidenceAndEqualOnesStay) {
  std::vector<CandidateFinding> findings{
      finding("e", 0.1, 0.2, 1), finding("c", 0.1, 0.2, 7), finding("b", 0.1, 0.3, 0),
      finding("d", 0.1, 0.2, 1 + 1e-12), finding("a", 0.5, 0.5, 0)};
  sort_by_lead(findings);
  std::string order;
  for (const CandidateFinding& one : findings) order += one.effect;
  EXPECT_EQ(order, "abced");
}

}  // namespace
}  // namespace fogcomp::diagnosis
