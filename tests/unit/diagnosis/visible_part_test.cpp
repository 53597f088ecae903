#include "diagnosis/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/effect_list.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

class Fitted : public testing::Test {
 protected:
  Fitted() : series_(model_, series::Phase::zero) {
    series_.add(series::make_blocks(fog::test::recording_of(model_, fog::test::kQuietNoise, 1)));
    fit_ = fit::fit_rows(series_, model_.terms, Eigen::MatrixXd(series_.rows().size(), 0));
    remover_.emplace(series_.rows(), fit_);
  }
  VisiblePart visible(const std::string& effect) const {
    return (*remover_)(series_.regressors(model::parse_effects(effect)[0]));
  }

  model::Model model_ = fog::test::truth();
  series::SignalSeries series_;
  fit::NoiseWeightedFit fit_;
  std::optional<Residualizer> remover_;
};
using VisiblePartTest = Fitted;

TEST_F(VisiblePartTest, OfTheModelsOwnTermsIsNothing) {
  for (const char* const own : {"bias", "bias_temperature:order=3", "temperature_rate"}) {
    EXPECT_LT(visible(own).visible.maxCoeff(), 0.03) << own;
  }
}

TEST_F(VisiblePartTest, OfSomethingElseIsMostOfIt) {
  for (const char* const other : {"polarization_ripple:period=9", "thermal_hysteresis:radius=5"}) {
    const Eigen::VectorXd share = visible(other).visible;
    EXPECT_GT(share.maxCoeff(), 0.3) << other;
    EXPECT_LE(share.maxCoeff(), 1 + 1e-9) << other;
    EXPECT_GE(share.minCoeff(), 0) << other;
  }
}

// The model is projected out completely: visible parts are orthogonal to it.
TEST_F(VisiblePartTest, IsAtRightAnglesToTheResidualsModel) {
  const Eigen::MatrixXd columns = visible("polarization_ripple:period=9").columns;
  const Eigen::MatrixXd own = visible("temperature_rate").columns;
  EXPECT_EQ(columns.rows(), remover_->residual().size());
  EXPECT_LT((columns.transpose() * own).norm(), 0.03 * columns.norm() * own.norm() + 1e-6);
}

TEST_F(VisiblePartTest, DoesNotDependOnTheColumnsSizeAndIsAdditive) {
  const Eigen::MatrixXd a = series_.regressors(model::parse_effects("warm_up:tau=2000")[0]);
  const Eigen::MatrixXd b = series_.regressors(model::parse_effects("thermal_lag:tau=1500")[0]);
  const VisiblePart once = (*remover_)(a);
  const VisiblePart thrice = (*remover_)(3 * a);
  EXPECT_NEAR(thrice.visible[0], once.visible[0], 1e-9);
  EXPECT_LT((thrice.columns - 3 * once.columns).norm(), 1e-9 * thrice.columns.norm());
  const VisiblePart sum = (*remover_)(a + b);
  EXPECT_LT((sum.columns - once.columns - (*remover_)(b).columns).norm(),
            1e-9 * sum.columns.norm());
}

// No formula of the catalogue is exact: a twentieth of a term that bends with temperature is at
// most one sigma; ten times as much is a missing effect.
TEST_F(VisiblePartTest, OfATermThatBendsALittleIsNotSeen) {
  Eigen::VectorXd bent = fit_.columns.rightCols(1) * fit_.coefficients.tail(1);
  for (Eigen::Index i = 0; i < bent.size(); ++i) {
    const auto& signals = series_.rows().signals[static_cast<std::size_t>(i)];
    bent[i] *= signals.temperature / 50;
  }
  const double seen = (*remover_)(bent).columns.norm();
  EXPECT_LT(0.05 * seen, 1);
  EXPECT_GT(0.5 * seen, 5);
}

TEST_F(VisiblePartTest, OfNothingIsNothing) {
  const VisiblePart part = (*remover_)(Eigen::MatrixXd::Zero(series_.rows().size(), 1));
  EXPECT_EQ(part.visible[0], 0);
  EXPECT_TRUE(part.columns.isZero());
}

// The gyro equals the model: the residual is noise of variance 1.
TEST_F(VisiblePartTest, OfTheMeasurementIsNoise) {
  const Eigen::VectorXd& residual = remover_->residual();
  EXPECT_NEAR(residual.squaredNorm() / static_cast<double>(series_.rows().size()), 1, 0.08);
}

// A sine of a rate table, and a model with the delay of its record: were it allowed to be late like
// a temperature, a minute of it would be a scale factor.
TEST(VisiblePartOnATable, OfAScaleFactorIsAllOfIt) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double angle = recording.time_s[i] * 0.002;
    recording.input_rate_dph.push_back(72000 * std::sin(angle));
    recording.rate_dph[i] += recording.input_rate_dph.back() + 10 * std::cos(angle);
  }
  const model::Model model = fog::test::model_of(
      model::parse_effects("bias,bias_temperature:order=3,temperature_rate,late_reference"));
  series::SignalSeries series(model, series::Phase::zero);
  series.add(series::make_blocks(recording));
  const auto fit = fit::fit_rows(series, model.terms, Eigen::MatrixXd(series.rows().size(), 0));
  const Residualizer remover(series.rows(), fit);
  const auto scale_factor = series.regressors(model::parse_effects("scale_factor")[0]);
  EXPECT_GT(remover(scale_factor).visible[0], 0.9);
}

}  // namespace
}  // namespace fogcomp::diagnosis
