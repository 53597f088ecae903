#include "diagnosis/evidence_space.hpp"

#include "noise/random_walk.hpp"

namespace fogcomp::diagnosis {

EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  const std::function<void(double)>& progress) {
  const series::SignalSeries& series = data.series();
  ModelRemover remover(series.rows(), fit);
  const ToVisible to_visible = [&](const Eigen::MatrixXd& columns) { return remover(columns); };
  CandidateList list =
      find_candidates(series, fit.terms, data.offered(), data.inputs(), to_visible, progress);
  sharpen(list.testable, series, fit.terms, to_visible, remover.residual());
  VisibleStructure smooth = visible_structure(series.rows(), remover);

  fit::ExplainedSpace space(remover.residual());
  Library library;
  for (const Candidate& candidate : list.testable) {
    library.emplace_back();
    for (const Candidate::Shape& shape : candidate.shapes) {
      library.back().push_back(space.add(shape.basis));
    }
  }
  const series::ColumnRange structure = space.add(smooth.all);
  fit::WalkModes walk =
      fit::add_walk(space, remover(noise::random_walk_modes(series.rows())).columns);
  space.finish();
  return {std::move(remover), std::move(list.testable), std::move(list.untestable),
          std::move(smooth),  std::move(space),         std::move(library),
          structure,          std::move(walk)};
}

Eigen::VectorXd without(const EvidenceSpace& evidence, const Hypothesis& hypothesis,
                        Eigen::Index rows) {
  std::vector<series::ColumnRange> ranges = ranges_of(evidence.library, hypothesis);
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
