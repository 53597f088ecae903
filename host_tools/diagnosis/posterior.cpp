#include "diagnosis/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/shape_grid.hpp"
#include "model/catalogue.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

// What the model and effects of one shape can do.
Eigen::MatrixXd of_one_shape(const EvidenceSpace& evidence, const series::SignalSeries& series) {
  const judge::Rows& rows = evidence.modes.rows();
  std::vector<Eigen::MatrixXd> columns{Eigen::MatrixXd::Ones(rows.size(), 1)};
  for (Eigen::Index i = 0; i < rows.columns.cols(); ++i) {
    if (!(rows.prior_sigma[i] > 0)) columns.push_back(rows.columns.col(i));
  }
  for (const Candidate& candidate : evidence.candidates) {
    if (candidate.has_free_shape() || candidate.is_event() || candidate.is_expression()) continue;
    columns.push_back(columns_of(candidate.shapes[0], series));
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

judge::Explanations explain(EvidenceSpace& evidence, const series::SignalSeries& series) {
  Eigen::MatrixXd smooth = something_else(std::exchange(evidence.smooth.raw, {}),
                                          of_one_shape(evidence, series), evidence.modes.rows());
  std::vector<judge::PossibleEffect> effects;
  for (Candidate& candidate : evidence.candidates) {
    effects.push_back({{}, may_repeat(candidate)});
    for (Candidate::Shape& shape : candidate.shapes) {
      effects.back().shapes.push_back(std::move(shape.modes));
    }
  }
  return judge::explain(evidence.modes, std::move(smooth), std::move(effects));
}

}  // namespace fogcomp::diagnosis
