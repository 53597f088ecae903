#include "diagnosis/evidence_space.hpp"

#include <gtest/gtest.h>

#include "diagnosis/candidates.hpp"
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
    const Eigen::MatrixXf basis = basis_of(shape, made.series(), evidence.residualizer);
    EXPECT_LT((basis.cast<double>().transpose() * left).norm(), 1e-6 * size);
  }
  EXPECT_LT((evidence.smooth.all.cast<double>().transpose() * left).norm(), 1e-6 * size);
}

TEST(EvidenceSpace, HoldsEveryShapeOfEveryCandidate) {
  const model::Model model = fog::test::truth();
  DiagnosisData data(model, {runs::run_of(quiet_gyro(), {model.average_s})});
  const fit::NoiseWeightedFit fit =
      fit::fit_rows(data.series(), model.terms, Eigen::MatrixXd(data.series().rows().size(), 0));
  double done = 0;
  const EvidenceSpace evidence =
      make_evidence_space(data, fit, false, [&](double share) { done = std::max(done, share); });
  EXPECT_GT(done, 0.5);
  EXPECT_LE(done, 1);
  ASSERT_GT(evidence.candidates.size(), 4U);
  for (const Candidate& candidate : evidence.candidates) {
    ASSERT_FALSE(candidate.shapes.empty()) << candidate.effect;
    for (const Candidate::Shape& shape : candidate.shapes) {
      EXPECT_EQ(shape.basis.size(), 0);
      EXPECT_GT(shape.modes.rows(), 0);
      EXPECT_LE(shape.modes.rows(), data.series().rows().size());
      EXPECT_EQ(shape.modes.cols(), static_cast<Eigen::Index>(shape.visible.size()));
    }
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
