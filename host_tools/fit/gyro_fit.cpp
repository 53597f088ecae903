#include "fit/gyro_fit.hpp"

#include <cmath>

#include "fit/predict.hpp"
#include "fit/undetermined.hpp"

namespace fogcomp::fit {
namespace {

// Values and covariance of the terms' coefficients and shapes; `linear`: columns before the shapes.
GyroFit values_of(const judge::Prediction& found, const NoiseWeightedFit& fit, double row_s) {
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, row_s);
  const Eigen::Index coefficients = columns.back().first + columns.back().count;
  const auto shapes = static_cast<Eigen::Index>(fit.shapes.size());
  const Eigen::Index linear = found.mean().size() - shapes;
  std::vector<Eigen::Index> own;
  for (Eigen::Index i = 0; i < coefficients; ++i) own.push_back(i);
  for (Eigen::Index i = 0; i < shapes; ++i) own.push_back(linear + i);
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(coefficients + shapes);  // positions -> values
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    const model::ShapeParameter& shape = fit.shapes[i];
    unit[coefficients + static_cast<Eigen::Index>(i)] =
        shape.slope(fit.terms[shape.term].parameters[shape.index].value);
  }
  GyroFit gyro;
  Eigen::MatrixXd& covariance = gyro.uncertainty.covariance;
  covariance = unit.asDiagonal() * found.covariance()(own, own) * unit.asDiagonal();
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    const auto [first, count] = columns[i];
    model::GyroValues& values = gyro.terms.emplace_back();
    for (const model::Parameter& parameter : fit.terms[i].parameters)
      values.shape.emplace_back(parameter.value);
    for (Eigen::Index k = first; k < first + count; ++k)
      values.coefficients_dph.emplace_back(found.mean()[k], sigma[k]);
  }
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    gyro.terms[fit.shapes[i].term].shape[fit.shapes[i].index].sigma =
        sigma[coefficients + static_cast<Eigen::Index>(i)];
  }
  gyro.uncertainty.white_dph = found.noise().white_dph;
  gyro.uncertainty.flicker_dph = found.noise().flicker_dph;
  gyro.uncertainty.walk_dph_per_rth = found.noise().walk_dph_per_rth;
  gyro.uncertainty.turn_on_dph = found.noise().turn_on_dph;
  return gyro;
}

}  // namespace

std::optional<GyroFit> values_of_gyro(const KnownRegressors& known, const NoiseWeightedFit& fit,
                                      const series::ColumnRange& offsets) {
  if (!is_determined(fit)) return std::nullopt;
  const series::Rows& rows = known.series().rows();
  return values_of(predict(rows, fit, offsets, temperature_error(known, fit)), fit, rows.row_s);
}

}  // namespace fogcomp::fit
