#include "diagnosis/evidence_space.hpp"

#include <algorithm>

#include "diagnosis/step_candidates.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

// A few columns at a time: less memory than all of them.
Eigen::MatrixXf visible_of(const Eigen::MatrixXf& columns, const Residualizer& residualizer) {
  constexpr Eigen::Index kAtOnce = 16;
  Eigen::MatrixXf visible(residualizer.residual().size(), columns.cols());
  for (Eigen::Index first = 0; first < columns.cols(); first += kAtOnce) {
    const Eigen::Index count = std::min(kAtOnce, columns.cols() - first);
    const Eigen::MatrixXd some = columns.middleCols(first, count).cast<double>();
    visible.middleCols(first, count) = residualizer(some).columns.cast<float>();
  }
  return visible;
}

// Columns that may explain the residual.
struct PossibleColumns {
  CandidateList candidates;
  VisibleStructure smooth;
  Eigen::MatrixXf walk_modes;
};

void put_steps_in_place(const series::SignalSeries& series, const Residualizer& residualizer,
                        PossibleColumns& found) {
  for (Candidate& candidate : found.candidates.testable) {
    if (!candidate.is_event()) continue;
    place_steps(candidate.shapes, series, residualizer, found.smooth.all);
    remove_gradual_steps(candidate.shapes, series.rows(), residualizer);
  }
  remove_those_without_shapes(found.candidates.testable);
}

// Candidates and steps use all threads only in part; smooth functions and the walk's modes keep
// one of them busy beside each.
PossibleColumns possible_columns(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                 const Residualizer& residualizer,
                                 const std::function<void(double)>& progress) {
  const series::SignalSeries& series = data.series();
  const ProjectOutModel project_out_model = [&](const Eigen::MatrixXd& columns) {
    return residualizer(columns);
  };
  PossibleColumns found;
  for_each_index(2, [&](std::size_t i) {
    if (i == 0) {
      found.candidates = find_candidates(series, fit.terms, data.offered(), data.inputs(),
                                         project_out_model, progress);
      refine_shape_parameters(found.candidates.testable, series, fit.terms, project_out_model,
                              residualizer.residual());
    } else {
      found.smooth = visible_structure(series.rows(), residualizer);
    }
  });
  for_each_index(2, [&](std::size_t i) {
    if (i == 0) {
      put_steps_in_place(series, residualizer, found);
    } else {
      found.walk_modes =
          visible_of(fit::visible_walk_modes(series.rows(), fit.noise), residualizer);
    }
  });
  return found;
}

}  // namespace

EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  const std::function<void(double)>& progress) {
  Residualizer residualizer(data.series().rows(), fit);
  PossibleColumns columns = possible_columns(data, fit, residualizer, progress);
  fit::ExplainedSpace space(residualizer.residual());
  RegressorBasis regressors;
  for (const Candidate& candidate : columns.candidates.testable) {
    regressors.emplace_back();
    for (const Candidate::Shape& shape : candidate.shapes) {
      regressors.back().push_back(space.add(shape.basis));
    }
  }
  const series::ColumnRange structure = space.add(columns.smooth.all);
  fit::WalkModes walk = fit::add_walk(space, columns.walk_modes);
  space.finish();
  return {std::move(residualizer),
          std::move(columns.candidates.testable),
          std::move(columns.candidates.untestable),
          std::move(columns.smooth),
          std::move(space),
          std::move(regressors),
          structure,
          std::move(walk)};
}

Eigen::VectorXd without(const EvidenceSpace& evidence, const Hypothesis& hypothesis,
                        Eigen::Index rows) {
  std::vector<series::ColumnRange> ranges = ranges_of(evidence.regressors, hypothesis);
  ranges.push_back(evidence.structure);
  const Eigen::VectorXd coefficients = evidence.space.coefficients(ranges);
  Eigen::VectorXd left = evidence.residual();
  Eigen::Index at = 0;
  for (const Hypothesis::Part& part : hypothesis.parts) {
    const Eigen::MatrixXf& basis = evidence.candidates[part.candidate].shapes[part.shape].basis;
    left -= basis.cast<double>() * coefficients.segment(at, basis.cols());
    at += basis.cols();
  }
  left -= evidence.smooth.all.cast<double>() * coefficients.tail(evidence.smooth.all.cols());
  return left.head(rows);
}

}  // namespace fogcomp::diagnosis
