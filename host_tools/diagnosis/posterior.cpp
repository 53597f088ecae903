#include "diagnosis/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/inexact_terms.hpp"
#include "fit/predict.hpp"
#include "model/catalogue.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

judge::Rows rows_with_nuisances(const EvidenceSpace& evidence, const series::SignalSeries& series,
                                const fit::NoiseWeightedFit& fit) {
  const series::Rows& rows = series.rows();
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  const Eigen::Index terms = columns.empty() ? 0 : columns.back().first + columns.back().count;
  judge::Rows judged = fit::judged_rows(rows, fit, {terms, fit.linear() - terms});
  const std::vector<recording::RowRange> power_ons = rows.bias_ranges();
  if (power_ons.size() > 1) judged.power_ons = power_ons;
  const Eigen::Index known = judged.columns.cols();
  judged.columns =
      side_by_side({judged.columns, evidence.residualizer.inexact(),
                    fit::unresolved_drift(rows, fit.terms, fit.columns, fit.coefficients,
                                          series.thermometer().unresolved_s())},
                   rows.size());
  judged.prior_sigma.conservativeResize(judged.columns.cols());
  judged.prior_sigma.tail(judged.columns.cols() - known).setOnes();
  return judged;
}

// What the model and effects of one shape can do.
Eigen::MatrixXd of_one_shape(const EvidenceSpace& evidence,
                             const std::vector<judge::PossibleEffect>& effects,
                             const judge::Rows& rows) {
  std::vector<Eigen::MatrixXd> columns{Eigen::MatrixXd::Ones(rows.size(), 1)};
  for (Eigen::Index i = 0; i < rows.columns.cols(); ++i) {
    if (!(rows.prior_sigma[i] > 0)) columns.push_back(rows.columns.col(i));
  }
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Candidate& candidate = evidence.candidates[i];
    if (candidate.has_free_shape() || candidate.is_event() || candidate.is_expression()) continue;
    columns.push_back(effects[i].shapes[0].cast<double>());
  }
  return side_by_side(columns, rows.size());
}

// Groups of smooth functions of one variable each, equally large. What changes in time alone is
// taken for noise, and what an effect of one shape does is that effect.
Eigen::MatrixXd something_else(const std::vector<StructureGroup>& groups,
                               const Eigen::MatrixXd& of_one_shape, const judge::Rows& rows) {
  std::vector<Eigen::MatrixXd> smooth;
  for (const StructureGroup& group : groups) {
    if (group.variable == "time_s" || group.columns.cols() == 0) continue;
    const Eigen::MatrixXd centred = group.columns.rowwise() - group.columns.colwise().mean();
    const double power = centred.squaredNorm() / static_cast<double>(rows.size());
    if (power > 0) smooth.push_back(centred / std::sqrt(power));
  }
  return projected_out(orthonormal(of_one_shape), side_by_side(smooth, rows.size()));
}

// Whether the effect has an optional second part of the same form.
bool may_repeat(const Candidate& candidate) {
  if (candidate.is_expression()) return false;
  const auto& parameters = model::find_effect(candidate.effect).parameters;
  return std::any_of(parameters.begin(), parameters.end(), model::is_optional_part);
}

}  // namespace

judge::Explanations explain(EvidenceSpace& evidence, const series::SignalSeries& series,
                            const fit::NoiseWeightedFit& fit, bool is_noise_known) {
  judge::Rows judged = rows_with_nuisances(evidence, series, fit);
  judged.temperature = fit::temperature_error(series, fit);
  if (is_noise_known) judged.noise = fit.noise;
  std::vector<judge::PossibleEffect> effects;
  for (Candidate& candidate : evidence.candidates) {
    effects.push_back({{}, may_repeat(candidate)});
    for (Candidate::Shape& shape : candidate.shapes) {
      shape.basis.resize(0, 0);
      effects.back().shapes.push_back(std::move(shape.columns));
    }
  }
  Eigen::MatrixXd smooth = something_else(std::exchange(evidence.smooth.raw, {}),
                                          of_one_shape(evidence, effects, judged), judged);
  return judge::explain(judged, std::move(smooth), std::move(effects));
}

}  // namespace fogcomp::diagnosis
