#include "fit/noise_weighted_fit.hpp"

#include <gtest/gtest.h>

#include "fit/undetermined.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::model_of;
using fog::test::recording_of;
using fog::test::RowNoise;
using fog::test::truth;

constexpr RowNoise kWhite{0.024, 0, 300};

// A gyro with the effects of truth(), in rows of 10 s.
class Gyro {
 public:
  explicit Gyro(const RowNoise& noise, const std::function<void(recording::Recording&)>& spoil = {})
      : series_(model_) {
    recording::Recording recording = recording_of(model_, noise, 1);
    if (spoil) spoil(recording);
    series_.add(series::make_blocks(recording));
  }
  const series::SignalSeries& series() const { return series_; }
  Eigen::MatrixXd no_nuisance() const { return {series_.rows().size(), 0}; }
  Eigen::VectorXd all() const { return Eigen::VectorXd::Ones(series_.rows().size()); }
  // Largest error of a coefficient, in deg/h of its regressor.
  double error_of(const NoiseWeightedFit& fit) const {
    double worst = 0;
    Eigen::Index column = 0;
    for (const model::EffectTerm& term : model_.terms) {
      for (const model::Estimate& coefficient : term.coefficients_dph) {
        worst = std::max(worst, std::abs(fit.coefficients[column++] - coefficient.value));
      }
    }
    return worst;
  }
  const model::Model& model() const { return model_; }

 private:
  model::Model model_ = truth();
  series::SignalSeries series_;
};

TEST(NoiseWeightedFit, IsExactWithoutNoise) {
  const Gyro gyro({});
  const auto fit = fit_rows(gyro.series(), gyro.model().terms, gyro.no_nuisance());
  EXPECT_LT(gyro.error_of(fit), 1e-6);
  EXPECT_LT(fit.residual_dph.cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_TRUE(is_determined(fit));
}

TEST(NoiseWeightedFit, LeavesWhitenedRowsOfVarianceOne) {
  const Gyro gyro(kWhite);
  const auto fit = fit_rows(gyro.series(), gyro.model().terms, gyro.no_nuisance());
  EXPECT_NEAR(fit.birge_ratio(), 1, 0.05);
  EXPECT_NEAR(fit.noise.white_dph(), kWhite.white_dph, 0.1 * kWhite.white_dph);
}

TEST(NoiseWeightedFit, IsHardlyMovedByRowsFarOffWhichItCounts) {
  constexpr std::size_t kWild = 36;
  const Gyro gyro(kWhite, [](recording::Recording& recording) {
    for (std::size_t i = 0; i < kWild; ++i) recording.rate_dph[200 + 77 * i] += 5;
  });
  const auto fit = fit_rows(gyro.series(), gyro.model().terms, gyro.no_nuisance());
  // Plain least squares would be off by 5 deg/h * 36 rows of 3,100, 0.06 deg/h.
  EXPECT_LT(gyro.error_of(fit), 0.02);
  EXPECT_GE(fit.outliers, kWild);
  EXPECT_LT(fit.outliers, 2 * kWild);
}

TEST(NoiseWeightedFit, DoesNotLookAtRowsThatAreLeftOut) {
  const Gyro clean(kWhite);
  const Gyro spoilt(kWhite, [](recording::Recording& recording) {
    for (std::size_t i = 500; i < 600; ++i) recording.rate_dph[i] = 1e4;
  });
  Eigen::VectorXd kept = clean.all();
  // The board's delay: a row contributes to the next as well.
  kept.segment(498, 106).setZero();
  const auto expected =
      fit_rows(clean.series(), clean.model().terms, clean.no_nuisance(), {kept, {}});
  const auto fit =
      fit_rows(spoilt.series(), spoilt.model().terms, spoilt.no_nuisance(), {kept, {}});
  EXPECT_LT((fit.coefficients - expected.coefficients).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(fit.outliers, expected.outliers);
}

TEST(NoiseWeightedFit, SaysWhatTheRowsCannotTellApart) {
  const Gyro gyro(kWhite);
  const auto terms = model::parse_effects("bias,temperature_rate");
  const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(gyro.series().rows().size(), 1);
  const auto fit = fit_rows(gyro.series(), terms, constant);
  EXPECT_EQ(fit.linear(), 3);
  EXPECT_FALSE(is_determined(fit));
  EXPECT_TRUE(fit.residual_dph.allFinite());
  EXPECT_THROW(fit_determined(gyro.series(), terms, constant), InputError);
}

TEST(NoiseWeightedFit, RefusesFewerRowsThanUnknowns) {
  const model::Model model = truth();
  recording::Recording recording = recording_of(model, kWhite, 1);
  for (auto* column : {&recording.time_s, &recording.temperature_degc, &recording.rate_dph}) {
    column->resize(6);
  }
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  const Eigen::Index rows = series.rows().size();
  EXPECT_THROW(fit_determined(series, model::parse_effects("bias,bias_temperature:order=9"),
                              Eigen::MatrixXd(rows, 0)),
               InputError);
}

TEST(RunOffsets, AreOnesInEveryRecordingButTheFirst) {
  series::Rows rows;
  rows.drift_dph = Eigen::VectorXd::Zero(6);
  rows.run_starts = {0, 2, 5};
  Eigen::MatrixXd expected(6, 2);
  expected << 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1;
  EXPECT_EQ(run_offset_columns(rows), expected);
  EXPECT_EQ(run_offset_columns(rows, false).cols(), 0);
  EXPECT_EQ(step_column(rows, 3), (Eigen::VectorXd(6) << 0, 0, 0, 1, 1, 0).finished());
}

}  // namespace
}  // namespace fogcomp::fit
