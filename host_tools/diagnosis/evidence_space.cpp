#include "diagnosis/evidence_space.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "diagnosis/shape_grid.hpp"
#include "diagnosis/step_candidates.hpp"
#include "model/catalogue.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

// Columns that may explain the residual.
struct PossibleColumns {
  CandidateList candidates;
  VisibleStructure smooth;
};

void put_steps_in_place(const series::SignalSeries& series, const fit::NoiseWeightedFit& fit,
                        const Residualizer& residualizer, PossibleColumns& found) {
  for (Candidate& candidate : found.candidates.testable) {
    if (!candidate.is_event()) continue;
    place_steps(candidate.shapes, series, residualizer, found.smooth.all);
    remove_gradual_steps(candidate.shapes, series.rows(), fit);
  }
  remove_those_without_shapes(found.candidates.testable);
}

// Candidates use all threads only in part; smooth functions keep one of them busy beside them.
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
  put_steps_in_place(series, fit, residualizer, found);
  return found;
}

// Gives a term the first part of `other` as its optional second part, if it has none yet.
void add_part(model::EffectTerm& term, const model::EffectTerm& other) {
  const auto& parameters = model::find_effect(term.name).parameters;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    if (!model::is_optional_part(parameters[i]) || term.parameters[i].value != 0) continue;
    double& first = term.parameters[i - 1].value;
    std::tie(first, term.parameters[i].value) = std::minmax({first, other.parameters[i - 1].value});
    return;
  }
}

}  // namespace

model::EffectTerm EvidenceSpace::term_in(const std::vector<judge::Part>& parts,
                                         std::size_t candidate) const {
  std::optional<model::EffectTerm> term;
  for (const judge::Part& part : parts) {
    if (part.effect != candidate) continue;
    const model::EffectTerm& one = candidates[candidate].shapes[part.shape].term;
    if (term) {
      add_part(*term, one);
    } else {
      term = one;
    }
  }
  return *term;
}

EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  const std::function<void(double)>& progress) {
  Residualizer residualizer(data.series().rows(), fit);
  PossibleColumns columns = possible_columns(data, fit, residualizer, progress);
  return {std::move(residualizer), std::move(columns.candidates.testable),
          std::move(columns.candidates.untestable), std::move(columns.smooth)};
}

Eigen::VectorXd without(const EvidenceSpace& evidence, const std::vector<judge::Part>& parts,
                        const series::SignalSeries& series) {
  std::vector<Eigen::MatrixXd> explained{evidence.smooth.all.cast<double>()};
  for (const judge::Part& part : parts) {
    const Candidate::Shape& shape = evidence.candidates[part.effect].shapes[part.shape];
    explained.push_back(basis_of(shape, series, evidence.residualizer).cast<double>());
  }
  const Eigen::MatrixXd basis = orthonormal(side_by_side(explained, evidence.residual().size()));
  return projected_out(basis, evidence.residual());
}

}  // namespace fogcomp::diagnosis
