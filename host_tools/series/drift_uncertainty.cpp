#include "series/drift_uncertainty.hpp"

#include <vector>

#include "model/shape_parameter.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::series {
namespace {

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
  for (const model::ShapeParameter& shape : shapes) {
    const model::EffectTerm& term = terms[shape.term];
    const auto drift_of = [&](const model::EffectTerm& moved) -> Eigen::VectorXd {
      return series.regressors(moved, Reading::of_gyro) * term.coefficients();
    };
    columns.col(at++) = model::derivative_by_unit(shape, term, drift_of) /
                        shape.slope(term.parameters[shape.index].value);
  }
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
