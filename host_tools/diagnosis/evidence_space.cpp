#include "diagnosis/evidence_space.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "diagnosis/candidates.hpp"
#include "diagnosis/step_candidates.hpp"
#include "fit/inexact_terms.hpp"
#include "fit/predict.hpp"
#include "model/catalogue.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

judge::Rows rows_with_nuisances(const series::SignalSeries& series,
                                const fit::NoiseWeightedFit& fit,
                                const Residualizer& residualizer) {
  const series::Rows& rows = series.rows();
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  const Eigen::Index terms = columns.empty() ? 0 : columns.back().first + columns.back().count;
  judge::Rows judged = fit::judged_rows(rows, fit, {terms, fit.linear() - terms});
  fit::add_nuisances(
      side_by_side({residualizer.inexact(),
                    fit::unresolved_drift(rows, fit.terms, fit.columns, fit.coefficients,
                                          series.thermometer().unresolved_s())},
                   rows.size()),
      1, judged);
  fit::add_biases(rows, judged);
  judged.temperature = fit::temperature_error(series, fit);
  return judged;
}

// Columns that may explain the residual.
struct PossibleColumns {
  CandidateList candidates;
  VisibleStructure smooth;
};

// Without bases, which only the search needs: they are half of its memory.
std::vector<Candidate> without_bases(std::vector<Candidate> candidates) {
  for (Candidate& candidate : candidates) {
    for (Candidate::Shape& shape : candidate.shapes) shape.basis.resize(0, 0);
  }
  return candidates;
}

std::vector<Candidate> with_steps_in_place(std::vector<Candidate> candidates,
                                           const ShapeSpace& space,
                                           const fit::NoiseWeightedFit& fit,
                                           const Residualizer& residualizer,
                                           const VisibleStructure& smooth) {
  for (Candidate& candidate : candidates) {
    if (!candidate.is_event()) continue;
    candidate.shapes = without_gradual_steps(
        placed_steps(std::move(candidate.shapes), space, residualizer, smooth.all),
        space.series.rows(), fit);
  }
  return with_shapes(std::move(candidates));
}

// Candidates use all threads only in part; smooth functions keep one of them busy beside them.
PossibleColumns possible_columns(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                 const Residualizer& residualizer, const judge::ModeSpace& modes,
                                 const std::function<void(double)>& progress) {
  const ProjectOutModel project_out_model = [&](const Eigen::MatrixXd& columns) {
    return residualizer(columns);
  };
  const ShapeSpace space{data.series(), project_out_model, modes};
  PossibleColumns found;
  for_each_index(2, [&](std::size_t i) {
    if (i == 0) {
      found.candidates = find_candidates(space, fit.terms, data.offered(), data.inputs(), progress);
      found.candidates.testable = with_best_shapes(std::move(found.candidates.testable), space,
                                                   fit.terms, residualizer.residual());
    } else {
      found.smooth = visible_structure(space.series.rows(), residualizer);
    }
  });
  found.candidates.testable = with_steps_in_place(
      without_bases(std::move(found.candidates.testable)), space, fit, residualizer, found.smooth);
  return found;
}

// The term with the first part of `other` as its optional second part, if it has none yet.
model::EffectTerm with_part(model::EffectTerm term, const model::EffectTerm& other) {
  const auto& parameters = model::find_effect(term.name).parameters;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    if (!model::is_optional_part(parameters[i]) || term.parameters[i].value != 0) continue;
    double& first = term.parameters[i - 1].value;
    std::tie(first, term.parameters[i].value) = std::minmax({first, other.parameters[i - 1].value});
    return term;
  }
  return term;
}

}  // namespace

model::EffectTerm EvidenceSpace::term_in(const std::vector<judge::Part>& parts,
                                         std::size_t candidate) const {
  std::optional<model::EffectTerm> term;
  for (const judge::Part& part : parts) {
    if (part.effect != candidate) continue;
    const model::EffectTerm& one = candidates[candidate].shapes[part.shape].term;
    term = term ? with_part(std::move(*term), one) : one;
  }
  return *term;
}

EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  bool is_noise_known,
                                  const std::function<void(double)>& progress) {
  Residualizer residualizer(data.series().rows(), fit);
  judge::Rows rows = rows_with_nuisances(data.series(), fit, residualizer);
  if (is_noise_known) rows.noise = fit.noise;
  judge::ModeSpace modes(std::move(rows));
  PossibleColumns columns = possible_columns(data, fit, residualizer, modes, progress);
  return {std::move(residualizer), std::move(modes), std::move(columns.candidates.testable),
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
