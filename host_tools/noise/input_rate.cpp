#include "noise/input_rate.hpp"

#include <algorithm>

#include "noise/decision_rules.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::noise {
namespace {

// Rows before and after, between which the temperature's change is taken: long against a sensor's
// resolution, short against lags.
constexpr Eigen::Index kNear = 3;

}  // namespace

Eigen::MatrixXd input_rate_columns(const Eigen::Ref<const Eigen::VectorXd>& input_rate_dph,
                                   const Eigen::Ref<const Eigen::VectorXd>& temperature_degc,
                                   Eigen::Index per_row) {
  const Eigen::Index rows = input_rate_dph.size();
  if (rows == 0 || input_rate_dph.minCoeff() == input_rate_dph.maxCoeff()) return {rows, 0};
  const Eigen::ArrayXd u = input_rate_dph.array() / input_rate_dph.cwiseAbs().maxCoeff();
  const double cold = temperature_degc.minCoeff();
  const double warm = temperature_degc.maxCoeff();
  const double half = warm > cold ? (warm - cold) / 2 : 1;
  const Eigen::ArrayXd x = (temperature_degc.array() - (warm + cold) / 2) / half;
  Eigen::ArrayXd change = Eigen::ArrayXd::Zero(rows);
  Eigen::ArrayXd bend = Eigen::ArrayXd::Zero(rows);
  for (Eigen::Index i = 1; i + 1 < rows; ++i) {
    change[i] = u[i + 1] - u[i - 1];
    bend[i] = u[i + 1] - 2 * u[i] + u[i - 1];
  }
  const Eigen::Index near = kNear * per_row;
  Eigen::ArrayXd warming(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    warming[i] = x[std::min(i + near, rows - 1)] - x[std::max<Eigen::Index>(i - near, 0)];
  }
  Eigen::MatrixXd columns(rows, 15);
  columns << u, u * x, u * x.square(), u * x.cube(), u * warming, u.square(), u.cube(), u.pow(4),
      u.pow(5), u.abs(), change, change * x, bend, change.square(), change.square() * u;
  return columns;
}

Eigen::MatrixXd input_rate_columns(const series::Rows& rows) {
  Eigen::VectorXd rate(rows.size());
  Eigen::VectorXd temperature(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    rate[i] = rows.inputs[static_cast<std::size_t>(i)].input_rate;
    temperature[i] = rows.inputs[static_cast<std::size_t>(i)].temperature;
  }
  return input_rate_columns(rate, temperature, 1);
}

double share_of_input_rate(Eigen::MatrixXd columns, const Eigen::VectorXd& values) {
  const Eigen::VectorXd around = values.array() - values.mean();
  if (columns.cols() == 0 || around.squaredNorm() == 0) return 0;
  columns.rowwise() -= columns.colwise().mean().eval();
  return 1 - solve_linear(columns, around).residual.squaredNorm() / around.squaredNorm();
}

Eigen::VectorXd without_input_rate(const series::Rows& rows, const Eigen::VectorXd& residual,
                                   const Eigen::VectorXd& weights) {
  const Eigen::MatrixXd columns = input_rate_columns(rows);
  const auto enough = static_cast<Eigen::Index>(rules::kMeansPerColumn) * columns.cols();
  if (columns.cols() == 0 || rows.size() <= enough) return residual;
  const Eigen::VectorXd kept = (weights.array() > 0).cast<double>();
  const LinearFit fit = solve_linear(kept.asDiagonal() * columns, kept.cwiseProduct(residual));
  return residual - columns * fit.coefficients;
}

}  // namespace fogcomp::noise
