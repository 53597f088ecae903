#include "diagnosis/posterior.hpp"

#include <algorithm>
#include <cmath>

#include "fit/predict.hpp"
#include "model/catalogue.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

judge::Rows rows_with_nuisances(const EvidenceSpace& evidence, const series::Rows& rows,
                                const fit::NoiseWeightedFit& fit) {
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  const Eigen::Index terms = columns.empty() ? 0 : columns.back().first + columns.back().count;
  judge::Rows judged = fit::judged_rows(rows, fit, {terms, fit.linear() - terms});
  const std::vector<recording::RowRange> power_ons = rows.bias_ranges();
  if (power_ons.size() > 1) judged.power_ons = power_ons;
  const Eigen::MatrixXd& inexact = evidence.residualizer.inexact();
  judged.columns = side_by_side({judged.columns, inexact}, rows.size());
  const Eigen::Index known = judged.prior_sigma.size();
  judged.prior_sigma.conservativeResize(known + inexact.cols());
  judged.prior_sigma.tail(inexact.cols()).setOnes();
  return judged;
}

// What the model and effects of one shape can do.
Eigen::MatrixXd of_one_shape(const EvidenceSpace& evidence, const judge::Rows& rows) {
  std::vector<Eigen::MatrixXd> columns{Eigen::MatrixXd::Ones(rows.size(), 1)};
  for (Eigen::Index i = 0; i < rows.columns.cols(); ++i) {
    if (!(rows.prior_sigma[i] > 0)) columns.push_back(rows.columns.col(i));
  }
  for (const Candidate& candidate : evidence.candidates) {
    if (candidate.has_free_shape() || candidate.is_event() || candidate.is_expression()) continue;
    columns.push_back(candidate.shapes[0].columns.cast<double>());
  }
  return side_by_side(columns, rows.size());
}

// Groups of smooth functions of one variable each, equally large. What changes in time alone is
// taken for noise, and what an effect of one shape does is that effect.
Eigen::MatrixXd something_else(const EvidenceSpace& evidence, const judge::Rows& rows) {
  std::vector<Eigen::MatrixXd> smooth;
  for (const StructureGroup& group : evidence.smooth.raw) {
    if (group.variable == "time_s" || group.columns.cols() == 0) continue;
    const Eigen::MatrixXd centred = group.columns.rowwise() - group.columns.colwise().mean();
    const double power = centred.squaredNorm() / static_cast<double>(rows.size());
    if (power > 0) smooth.push_back(centred / std::sqrt(power));
  }
  return projected_out(orthonormal(of_one_shape(evidence, rows)),
                       side_by_side(smooth, rows.size()));
}

// Whether the effect has an optional second part of the same form.
bool may_repeat(const Candidate& candidate) {
  if (candidate.is_expression()) return false;
  const auto& parameters = model::find_effect(candidate.effect).parameters;
  return std::any_of(parameters.begin(), parameters.end(), model::is_optional_part);
}

}  // namespace

judge::Explanations explain(const EvidenceSpace& evidence, const series::SignalSeries& series,
                            const fit::NoiseWeightedFit& fit, bool is_noise_known) {
  const series::Rows& rows = series.rows();
  std::vector<judge::PossibleEffect> effects;
  for (const Candidate& candidate : evidence.candidates) {
    judge::PossibleEffect effect;
    for (const Candidate::Shape& shape : candidate.shapes) effect.shapes.push_back(&shape.columns);
    effect.may_repeat = may_repeat(candidate);
    effects.push_back(std::move(effect));
  }
  judge::Rows judged = rows_with_nuisances(evidence, rows, fit);
  if (is_noise_known) judged.noise = fit.noise;
  return judge::explain(judged, something_else(evidence, judged), effects);
}

}  // namespace fogcomp::diagnosis
