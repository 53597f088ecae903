#include "fit/predict.hpp"

#include <cmath>

#include "support/least_squares.hpp"

namespace fogcomp::fit {

judge::Rows judged_rows(const series::Rows& rows, const NoiseWeightedFit& fit,
                        const series::ColumnRange& without) {
  const double anywhere = std::sqrt(1.0 / 12);  // standard deviation of a uniform position
  judge::Rows judged;
  judged.row_s = rows.row_s;
  judged.drift_dph = rows.drift_dph;
  const Eigen::Index behind = fit.linear() - without.first - without.count;
  judged.columns = side_by_side(
      {fit.columns.leftCols(without.first), fit.columns.rightCols(behind), fit.shape_columns},
      rows.size());
  judged.prior_sigma = Eigen::VectorXd::Zero(judged.columns.cols());
  judged.prior_sigma.tail(fit.shape_columns.cols()).setConstant(anywhere);
  judged.first_found = fit.linear() - without.count;
  judged.weights = fit.row_weights;
  judged.stretches = rows.stretches();
  return judged;
}

judge::Prediction predict(const series::Rows& rows, const NoiseWeightedFit& fit) {
  return judge::Prediction(judged_rows(rows, fit, {fit.linear(), 0}));
}

judge::Prediction predict(const series::Rows& rows, const NoiseWeightedFit& fit,
                          const series::ColumnRange& offsets,
                          const judge::TemperatureError& temperature) {
  judge::Rows judged = judged_rows(rows, fit, offsets);
  judged.temperature = temperature;
  const std::vector<recording::RowRange> power_ons = rows.power_ons();
  if (power_ons.size() > 1) judged.power_ons = power_ons;
  return judge::Prediction(judged);
}

}  // namespace fogcomp::fit
