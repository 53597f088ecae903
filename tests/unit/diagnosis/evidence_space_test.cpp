#include "diagnosis/evidence_space.hpp"

#include <gtest/gtest.h>

#include "unit/diagnosis/made_evidence.hpp"

namespace fogcomp::diagnosis {
namespace {

recording::Recording quiet_gyro() {
  return fog::test::thinned(fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1),
                            4);
}

Eigen::VectorXd without_all(const EvidenceSpace& evidence, const Hypothesis& hypothesis) {
  return without(evidence, hypothesis, evidence.residual().size());
}

TEST(EvidenceSpace, WithoutAnyEffectIsWhatSmoothFunctionsLeave) {
  const EvidenceSpace evidence = fog::test::MadeEvidence(quiet_gyro()).evidence();
  const Eigen::MatrixXd smooth = evidence.smooth.all.cast<double>();
  const Eigen::VectorXd expected =
      evidence.residual() - smooth * (smooth.transpose() * evidence.residual());
  EXPECT_LT((without_all(evidence, {}) - expected).norm(), 1e-6 * expected.norm());
  EXPECT_EQ(without(evidence, {}, 17), without_all(evidence, {}).head(17));
}

// Least squares: the residual is orthogonal to the removed part, and the squares decrease by what
// the space predicts for all columns together.
TEST(EvidenceSpace, WithoutAHypothesisIsAtRightAnglesToItsEffects) {
  const EvidenceSpace evidence =
      fog::test::MadeEvidence(quiet_gyro())
          .evidence({{"thermal_hysteresis:radius=3", "thermal_hysteresis:radius=8"},
                     {"polarization_ripple:period=9"}});
  Hypothesis hypothesis;
  hypothesis.parts = {{0, 1}, {1, 0}};
  const Eigen::VectorXd left = without_all(evidence, hypothesis);
  const double size = evidence.residual().norm();
  for (const Hypothesis::Part& part : hypothesis.parts) {
    const Candidate::Shape& shape = evidence.candidates[part.candidate].shapes[part.shape];
    EXPECT_LT((shape.basis.cast<double>().transpose() * left).norm(), 1e-6 * size);
  }
  EXPECT_LT((evidence.smooth.all.cast<double>().transpose() * left).norm(), 1e-6 * size);
  std::vector<series::ColumnRange> all = ranges_of(evidence.regressors, hypothesis);
  all.push_back(evidence.structure);
  EXPECT_NEAR(evidence.residual().squaredNorm() - left.squaredNorm(), evidence.space.chi2_drop(all),
              1e-6 * size * size);
}

// All candidates are in one space, in their order, with unit length.
TEST(EvidenceSpace, HoldsEveryShapeOfEveryCandidate) {
  const model::Model model = fog::test::truth();
  DiagnosisData data(model, {runs::run_of(quiet_gyro(), {model.average_s})});
  const fit::NoiseWeightedFit fit =
      fit::fit_rows(data.series(), model.terms, Eigen::MatrixXd(data.series().rows().size(), 0));
  double done = 0;
  const EvidenceSpace evidence =
      make_evidence_space(data, fit, [&](double share) { done = std::max(done, share); });
  EXPECT_GT(done, 0.5);
  EXPECT_LE(done, 1);
  ASSERT_EQ(evidence.regressors.size(), evidence.candidates.size());
  ASSERT_GT(evidence.candidates.size(), 4U);
  for (std::size_t i = 0; i < evidence.candidates.size(); ++i) {
    const auto& shapes = evidence.candidates[i].shapes;
    ASSERT_EQ(evidence.regressors[i].size(), shapes.size());
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      const auto [first, count] = evidence.regressors[i][s];
      const Eigen::VectorXd projection =
          shapes[s].basis.cast<double>().transpose() * evidence.residual();
      EXPECT_LT((evidence.space.projection().segment(first, count) - projection).norm(), 1e-9)
          << evidence.candidates[i].effect;
      EXPECT_LT((evidence.space.gram().block(first, first, count, count) -
                 Eigen::MatrixXd::Identity(count, count))
                    .norm(),
                1e-7);
    }
  }
  EXPECT_EQ(evidence.structure.count, evidence.smooth.all.cols());
  EXPECT_GT(evidence.walk.columns.count, 0);
  EXPECT_EQ(evidence.walk.columns.first, evidence.structure.first + evidence.structure.count);
}

}  // namespace
}  // namespace fogcomp::diagnosis
