#include "diagnosis/evidence_space.hpp"

#include "diagnosis/step_candidates.hpp"

namespace fogcomp::diagnosis {

EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  const std::function<void(double)>& progress) {
  const series::SignalSeries& series = data.series();
  Residualizer residualizer(series.rows(), fit);
  const ProjectOutModel project_out_model = [&](const Eigen::MatrixXd& columns) {
    return residualizer(columns);
  };
  CandidateList list = find_candidates(series, fit.terms, data.offered(), data.inputs(),
                                       project_out_model, progress);
  refine_shape_parameters(list.testable, series, fit.terms, project_out_model,
                          residualizer.residual());
  VisibleStructure smooth = visible_structure(series.rows(), residualizer);
  for (Candidate& candidate : list.testable) {
    if (candidate.is_event()) {
      place_steps(candidate.shapes, series, residualizer, smooth.all);
    }
  }

  fit::ExplainedSpace space(residualizer.residual());
  RegressorBasis regressors;
  for (const Candidate& candidate : list.testable) {
    regressors.emplace_back();
    for (const Candidate::Shape& shape : candidate.shapes) {
      regressors.back().push_back(space.add(shape.basis));
    }
  }
  const series::ColumnRange structure = space.add(smooth.all);
  fit::WalkModes walk =
      fit::add_walk(space, residualizer(fit::visible_walk_modes(series.rows(), fit.noise)).columns);
  space.finish();
  return {std::move(residualizer),
          std::move(list.testable),
          std::move(list.untestable),
          std::move(smooth),
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
    const Eigen::MatrixXd& basis = evidence.candidates[part.candidate].shapes[part.shape].basis;
    left -= basis * coefficients.segment(at, basis.cols());
    at += basis.cols();
  }
  left -= evidence.smooth.all * coefficients.tail(evidence.smooth.all.cols());
  return left.head(rows);
}

}  // namespace fogcomp::diagnosis
