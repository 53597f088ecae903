#include "series/drift_uncertainty.hpp"

#include <algorithm>
#include <vector>

#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::series {
namespace {

// By the value of a shape parameter.
Eigen::VectorXd derivative(const SignalSeries& series, const model::EffectTerm& term,
                           const model::ShapeParameter& shape) {
  constexpr double kStep = 1e-4;  // of its range
  const double value = term.parameters[shape.index].value;
  const double unit = shape.to_unit(value);
  model::EffectTerm moved = term;
  const auto drift_at = [&](double place) -> Eigen::VectorXd {
    shape.set_unit(moved, place);
    return series.regressors(moved, Reading::of_gyro) * term.coefficients();
  };
  const double up = std::min(unit + kStep, 1.0);
  const double down = std::max(unit - kStep, 0.0);
  return (drift_at(up) - drift_at(down)) / ((up - down) * shape.slope(value));
}

// Of the gyro's drift by each unknown, in the order of the covariance.
Eigen::MatrixXd unknown_columns(const model::Model& model, const SignalSeries& series) {
  std::vector<model::EffectTerm> terms;
  for (const model::EffectTerm& term : model.terms) {
    if (!model::is_found_event(term)) terms.push_back(model::of_gyro(term));
  }
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms);
  const std::vector<ColumnRange> ranges = columns_of(terms, series.rows().row_s);
  Eigen::MatrixXd columns(series.rows().size(), model::unknowns_of(model));
  for (std::size_t i = 0; i < terms.size(); ++i) {
    columns.middleCols(ranges[i].first, ranges[i].count) =
        series.regressors(terms[i], Reading::of_gyro);
  }
  Eigen::Index at = ranges.back().first + ranges.back().count;
  for (const model::ShapeParameter& shape : shapes)
    columns.col(at++) = derivative(series, terms[shape.term], shape);
  return columns;
}

}  // namespace

Eigen::VectorXd drift_sigma_dph(const model::Model& model, const SignalSeries& series) {
  const Eigen::MatrixXd columns = unknown_columns(model, series);
  const Eigen::VectorXd of_delay =
      series.drift_dph(model.terms) - series.drift_dph(model.terms, Reading::of_gyro);
  const Eigen::VectorXd variance =
      (columns * model.uncertainty->covariance).cwiseProduct(columns).rowwise().sum();
  return (variance.cwiseMax(0) + of_delay.cwiseAbs2()).cwiseSqrt();
}

}  // namespace fogcomp::series
