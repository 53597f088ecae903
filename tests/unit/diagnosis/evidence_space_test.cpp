#include "diagnosis/evidence_space.hpp"

#include <gtest/gtest.h>

#include "unit/diagnosis/made_evidence.hpp"

namespace fogcomp::diagnosis {
namespace {

recording::Recording quiet_gyro() {
  return fog::test::thinned(fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1),
                            4);
}

TEST(EvidenceSpace, WithoutAnyEffectIsWhatSmoothFunctionsLeave) {
  const fog::test::MadeEvidence made(quiet_gyro());
  const EvidenceSpace evidence = made.evidence();
  const Eigen::MatrixXd smooth = evidence.smooth.all.cast<double>();
  const Eigen::VectorXd expected =
      evidence.residual() - smooth * (smooth.transpose() * evidence.residual());
  EXPECT_LT((without(evidence, {}, made.series()) - expected).norm(), 1e-6 * expected.norm());
}

TEST(EvidenceSpace, WithoutASetIsAtRightAnglesToItsEffects) {
  const fog::test::MadeEvidence made(quiet_gyro());
  const EvidenceSpace evidence =
      made.evidence({{"thermal_hysteresis:radius=3", "thermal_hysteresis:radius=8"},
                     {"polarization_ripple:period=9"}});
  const std::vector<judge::Part> parts{{0, 1}, {1, 0}};
  const Eigen::VectorXd left = without(evidence, parts, made.series());
  const double size = evidence.residual().norm();
  for (const judge::Part& part : parts) {
    const Candidate::Shape& shape = evidence.candidates[part.effect].shapes[part.shape];
    EXPECT_LT((shape.basis.cast<double>().transpose() * left).norm(), 1e-6 * size);
  }
  EXPECT_LT((evidence.smooth.all.cast<double>().transpose() * left).norm(), 1e-6 * size);
}

// Whitened, of unit length, and as they are.
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
  ASSERT_GT(evidence.candidates.size(), 4U);
  for (const Candidate& candidate : evidence.candidates) {
    ASSERT_FALSE(candidate.shapes.empty()) << candidate.effect;
    for (const Candidate::Shape& shape : candidate.shapes) {
      const Eigen::MatrixXf gram = shape.basis.transpose() * shape.basis;
      EXPECT_LT((gram - Eigen::MatrixXf::Identity(gram.rows(), gram.cols())).norm(), 1e-5);
      EXPECT_EQ(shape.columns.rows(), data.series().rows().size());
      EXPECT_GE(shape.columns.cols(), shape.basis.cols());
    }
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
