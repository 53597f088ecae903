#include "fit/predict.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/noise_weighted_fit.hpp"
#include "support/units.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::model_of;
using fog::test::recording_of;
using fog::test::truth;

// A gyro with slow drift that is neither an effect nor noise; the rows where it is largest are
// excluded.
TEST(Predict, IsAVarianceWhereTheRowsLeftOutAreTheLargest) {
  const model::Model model = truth();
  recording::Recording recording = recording_of(model, {}, 1);
  const auto rows = static_cast<double>(recording.rows());
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.rate_dph[i] += 5 * std::cos(4 * kPi * static_cast<double>(i) / rows);
  }
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  const Eigen::MatrixXd no_nuisance(series.rows().size(), 0);
  NoiseWeightedFit fit = fit_rows(series, model.terms, no_nuisance);
  const Eigen::Index tenth = series.rows().size() / 10;
  for (const Eigen::Index at : {tenth * 4, tenth * 9}) fit.row_weights.segment(at, tenth).setZero();

  const Eigen::MatrixXd covariance = predict(series.rows(), fit).covariance();
  EXPECT_TRUE(covariance.allFinite());
  EXPECT_GT(covariance.diagonal().minCoeff(), 0);
}

}  // namespace
}  // namespace fogcomp::fit
