#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/candidates.hpp"
#include "diagnosis/decision_rules.hpp"
#include "diagnosis/evidence_space.hpp"
#include "diagnosis/late_ripple.hpp"
#include "diagnosis/model_fit.hpp"
#include "diagnosis/residual_place.hpp"
#include "judge/explanations.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "series/term_columns.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

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

// Probabilities of all explanations of what the model leaves: the candidates as effects, the smooth
// structure but for that of time as something else. Takes the modes of the candidates and the
// columns of the smooth structure but for VisibleStructure::all: they are most of a diagnosis'
// memory. `series`: that of the evidence.
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

std::vector<model::EffectTerm> fitted_terms(const fit::NoiseWeightedFit& fit, double row_s) {
  std::vector<model::EffectTerm> terms = fit.terms;
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, row_s);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    terms[i].set_coefficients(fit.coefficients.segment(columns[i].first, columns[i].count));
  }
  return terms;
}

std::vector<Diagnosis::Explanation> likeliest_sets(const EvidenceSpace& evidence,
                                                   const judge::Explanations& explanations) {
  constexpr std::size_t kTold = 6;
  std::vector<Diagnosis::Explanation> sets;
  for (const judge::Explanation& one : explanations.all) {
    if (sets.size() == kTold) break;
    if (one.parts.empty()) continue;
    Diagnosis::Explanation set;
    for (const judge::Part& part : one.parts) {
      set.effects.push_back(evidence.candidates[part.effect].effect);
    }
    set.probability = one.probability;
    set.complete = one.without_it;
    set.explained_fraction = one.explained;
    sets.push_back(std::move(set));
  }
  return sets;
}

// Experiment that separates the most probable rivals.
Experiment experiment_for_rivals(const model::Model& model, const Diagnosis& diagnosis) {
  constexpr std::size_t kMaxRivals = 3;
  std::vector<Rival> rivals;
  bool event = false;
  for (const std::string& effect : diagnosis.confusable) {
    if (rivals.size() == kMaxRivals) break;
    const CandidateFinding& finding = *diagnosis.find(effect);
    if (model::is_event(finding.term())) {
      event = true;
      continue;
    }
    rivals.push_back({effect, finding.completed, finding.possible});
  }
  if (rivals.size() > 1) return propose_experiment(model, rivals, diagnosis.noise);
  Experiment repeat;
  if (event) repeat.sentence = "record the same programme again: an event does not come back";
  return repeat;
}

struct Named {
  Verdict verdict = Verdict::unknown;
  std::string effect{};
  std::vector<std::string> confusable{};
};

// Several effects may be missing at once; the one that explains most is named.
Named named_effect(const Diagnosis& diagnosis) {
  const CandidateFinding& first = diagnosis.candidates.front();
  if (model::only_tail_is_seen(first.term())) return {};
  if (first.probability >= rules::kNamed) return {Verdict::missing_effect, first.effect};
  Named named{Verdict::ambiguous};
  for (const CandidateFinding& finding : diagnosis.candidates) {
    if (finding.lead >= rules::kConfusable) named.confusable.push_back(finding.effect);
  }
  return named;
}

// What the probabilities of a diagnosis say.
Named verdict_of(const Diagnosis& diagnosis) {
  if (diagnosis.fast_kind != FastKind::none) return {};
  if (diagnosis.nothing >= judge::kMissingBefore[0]) {
    return {diagnosis.leaves_noise() ? Verdict::none : Verdict::unknown};
  }
  if (!diagnosis.is_led_by_catalogue() || diagnosis.may_be_noise()) return {};
  return named_effect(diagnosis);
}

// The diagnosis with what is fast, and whether that is most of what is missing.
Diagnosis with_fast(Diagnosis diagnosis, const FastFinding& fast, double slow_excess) {
  diagnosis.fast = fast.spectrum;
  diagnosis.jumps = fast.jumps;
  if (fast.kind == FastKind::none || fast.excess <= kNoticeable * slow_excess) return diagnosis;
  diagnosis.fast_kind = fast.kind;
  diagnosis.fast_share = fast.excess / (fast.excess + slow_excess);
  if (fast.excess > slow_excess) diagnosis.variable = "time_s";
  return diagnosis;
}

// The diagnosis with its explanations compared, and a verdict.
Diagnosis judged(Diagnosis diagnosis, EvidenceSpace evidence, const series::SignalSeries& series,
                 const fit::NoiseWeightedFit& fit) {
  const judge::Explanations found = explain(evidence, series);
  diagnosis.nothing = found.nothing;
  diagnosis.something_else = found.something_else;
  diagnosis.mostly_something_else = found.mostly_something_else;
  diagnosis.unexplained_fraction = found.left_by_best;
  diagnosis.walk_dph_per_rth = found.noise_if_nothing.walk_dph_per_rth;
  const FastFinding fast = find_fast(evidence, found.all.front(), series, fit);
  diagnosis = with_fast(std::move(diagnosis), fast, found.excess);
  diagnosis.candidates = sorted_by_lead(find_of_candidates(evidence, found, series, fit));
  diagnosis.explanations = likeliest_sets(evidence, found);
  Named named = verdict_of(diagnosis);
  diagnosis.verdict = named.verdict;
  diagnosis.effect = std::move(named.effect);
  diagnosis.confusable = std::move(named.confusable);
  if (is_mainly_fast(diagnosis)) {
    diagnosis.late_ripples = find_late_ripples(series, fit.terms, fast.left);
  }
  return diagnosis;
}

// Reservations about the answer.
std::vector<std::string> limits_of(const Diagnosis& diagnosis) {
  std::vector<std::string> notes;
  if (diagnosis.candidates.empty()) {
    notes.emplace_back("these recordings can show none of the catalogue's effects");
  }
  return notes;
}

// What is left although nothing is missing: slow noise, which hides slow effects.
std::string blind_spot_of(const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::none) return "";
  const noise::NoiseModel& noise = diagnosis.noise;
  const double floor = diagnosis.has_static ? std::hypot(noise.white_dph(), noise.wander_dph())
                                            : diagnosis.noise_floor_dph;
  const double above =
      std::sqrt(std::max(0.0, std::pow(diagnosis.residual_rms_dph, 2) - std::pow(floor, 2)));
  if (above <= std::sqrt(rules::kSmallExcess) * floor) return "";
  return format("slow changes of %.3g deg/h rms are left; ", above) + diagnosis.walk_words();
}

// The diagnosis with where the residual is, and what may be missing.
Diagnosis with_causes(Diagnosis diagnosis, const model::Model& model, const DiagnosisData& data,
                      const fit::NoiseWeightedFit& fit, const DiagnosisSettings& settings) {
  const series::SignalSeries& series = data.series();
  // Candidates take most of the time, their comparison the rest.
  constexpr double kCandidates = 0.75;
  EvidenceSpace evidence =
      make_evidence_space(data, fit, settings.noise.has_value(), [&](double done) {
        if (settings.progress) settings.progress(kCandidates * done);
      });
  diagnosis.untestable = evidence.untestable;
  ResidualPlace place = place_of(evidence.smooth, evidence.residual(), data.segments());
  diagnosis.variable = std::move(place.variable);
  diagnosis.variables = std::move(place.variables);
  diagnosis.segments = std::move(place.segments);
  if (model.network.present()) {
    diagnosis.network =
        ask_network(model.network, series, evidence.candidates,
                    [&](const Eigen::MatrixXd& columns) { return evidence.residualizer(columns); });
  }
  diagnosis = judged(std::move(diagnosis), std::move(evidence), series, fit);
  for (CandidateFinding& finding : diagnosis.candidates) {
    if (model::is_event(finding.term())) finding.cut = data.cut_at(finding.term());
  }
  return diagnosis;
}

}  // namespace

Diagnosis diagnose(const model::Model& model, const DiagnosisData& data,
                   const DiagnosisSettings& settings) {
  const series::SignalSeries& series = data.series();
  const series::Rows& rows = series.rows();
  const fit::NoiseWeightedFit fit = fit_for_diagnosis(model, data, settings.noise);

  Diagnosis diagnosis;
  diagnosis.rows = rows.size();
  diagnosis.row_s = rows.row_s;
  diagnosis.noise = fit.noise;
  diagnosis.has_static = settings.noise.has_value();
  diagnosis.terms = fitted_terms(fit, rows.row_s);
  diagnosis.residual_rms_dph = rms_of_rows(rows, fit, fit.residual_dph);
  diagnosis.outliers = fit.outliers;
  diagnosis.residual_dph = fit.residual_dph;
  diagnosis.noise_floor_dph = data.noise_floor_dph().value_or(fit.noise.white_dph());

  diagnosis = with_causes(std::move(diagnosis), model, data, fit, settings);
  if (diagnosis.verdict == Verdict::ambiguous) {
    diagnosis.experiment = experiment_for_rivals(model, diagnosis);
  }
  diagnosis.notes = limits_of(diagnosis);
  diagnosis.blind_spot = blind_spot_of(diagnosis);
  return diagnosis;
}

}  // namespace fogcomp::diagnosis
