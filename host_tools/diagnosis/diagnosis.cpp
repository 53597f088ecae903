#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/evidence_space.hpp"
#include "diagnosis/explanation.hpp"
#include "diagnosis/hypotheses.hpp"
#include "diagnosis/late_ripple.hpp"
#include "diagnosis/model_fit.hpp"
#include "diagnosis/null_test.hpp"
#include "diagnosis/residual_place.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

std::vector<model::EffectTerm> fitted_terms(const fit::NoiseWeightedFit& fit, double row_s) {
  std::vector<model::EffectTerm> terms = fit.terms;
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, row_s);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    terms[i].set_coefficients(fit.coefficients.segment(columns[i].first, columns[i].count));
  }
  return terms;
}

std::vector<Diagnosis::Explanation> likeliest_sets(const EvidenceSpace& evidence,
                                                   const std::vector<Hypothesis>& hypotheses,
                                                   double excess) {
  constexpr std::size_t kTold = 6;
  std::vector<Diagnosis::Explanation> sets;
  for (std::size_t i = 0; i < std::min(kTold, hypotheses.size()); ++i) {
    const Hypothesis& hypothesis = hypotheses[i];
    Diagnosis::Explanation set;
    for (const Hypothesis::Part& part : hypothesis.parts) {
      set.effects.push_back(evidence.candidates[part.candidate].effect);
    }
    set.probability = hypothesis.probability;
    if (excess > 0) {
      const double columns = fit::column_count(ranges_of(evidence.regressors, hypothesis));
      set.explained_fraction = std::clamp((hypothesis.chi2_drop - columns) / excess, 0.0, 1.0);
    }
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

// Several effects may be missing at once; the one that explains most is named.
void name_effects(Diagnosis& diagnosis) {
  const CandidateFinding& first = diagnosis.candidates.front();
  if (model::only_tail_is_seen(first.term())) return;
  if (first.probability >= rules::kNamed) {
    diagnosis.verdict = Verdict::missing_effect;
    diagnosis.effect = first.effect;
    return;
  }
  diagnosis.verdict = Verdict::ambiguous;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    if (finding.lead >= rules::kConfusable) diagnosis.confusable.push_back(finding.effect);
  }
}

// The verdict where something is missing. `slow_excess`: chi^2 above noise of what is not fast.
// `may_be_named`: the catalogue explains that, and noise does not.
void decide(double slow_excess, const FastFinding& fast, bool may_be_named, Diagnosis& diagnosis) {
  const bool fast_left = fast.excess > rules::kMaxUnexplained[0] * (fast.excess + slow_excess);
  if (fast_left) {
    diagnosis.fast_kind = fast.kind;
    diagnosis.fast_share = fast.excess / (fast.excess + std::max(0.0, slow_excess));
    if (fast.excess > slow_excess) diagnosis.variable = "time_s";
  }
  diagnosis.verdict = Verdict::unknown;
  if (may_be_named && !fast_left && !diagnosis.walk.may_be_all()) name_effects(diagnosis);
}

struct Weighed {
  NullTest test;
  std::vector<Hypothesis> hypotheses;
};

// Both side by side: neither needs the other.
Weighed weigh(const EvidenceSpace& evidence, double degrees_of_freedom, std::uint64_t seed) {
  Weighed weighed;
  for_each_index(2, [&](std::size_t i) {
    if (i == 0) {
      weighed.test = test_against_noise(evidence.space, evidence.regressors, evidence.structure,
                                        degrees_of_freedom, seed);
    } else {
      weighed.hypotheses =
          find_hypotheses(evidence.space, evidence.candidates, evidence.regressors);
    }
  });
  return weighed;
}

// Tests the residual against noise, compares the hypotheses and sets the verdict.
void judge(const EvidenceSpace& evidence, const series::SignalSeries& series,
           const fit::NoiseWeightedFit& fit, std::uint64_t seed, Diagnosis& diagnosis) {
  const auto [test, hypotheses] = weigh(evidence, fit.noise.degrees_of_freedom, seed);
  if (hypotheses.empty()) return;
  const Explanation explanation =
      explain(evidence.space, evidence.regressors, evidence.structure, hypotheses);
  diagnosis.unexplained_fraction = explanation.unexplained;
  // What an effect beside the sufficient ones makes is no cycle of its own.
  const Hypothesis& fullest = hypotheses.front().chi2_drop > explanation.best->chi2_drop
                                  ? hypotheses.front()
                                  : *explanation.best;
  const FastFinding fast = find_fast(evidence, fullest, series, fit);
  diagnosis.fast = fast.spectrum;
  diagnosis.jumps = fast.jumps;
  diagnosis.tests = {test.library_log_p, test.structure_log_p, fast.log_p};
  diagnosis.chance = std::exp(std::min({test.library_log_p, test.structure_log_p, fast.log_p}));

  bool slow = test.finds_something();
  if (slow) diagnosis.walk = assess_walk(evidence, hypotheses, fit.noise, seed);
  const double small = rules::kSmallExcess * static_cast<double>(diagnosis.rows);
  if (slow && explanation.excess < small && diagnosis.walk.may_be_all()) {
    slow = false;
    diagnosis.chance = std::min(diagnosis.walk.noise_alone, std::exp(fast.log_p));
  }
  const bool something = slow || fast.kind != FastKind::none;
  diagnosis.candidates = find_of_candidates(evidence, hypotheses, explanation.excess, series, fit);
  if (!something) limit_to_own_evidence(diagnosis.candidates, diagnosis.walk.chance);
  sort_by_lead(diagnosis.candidates);
  diagnosis.explanations = likeliest_sets(evidence, hypotheses, explanation.excess);
  if (something) {
    const bool may_be_named = explanation.enough && test.library_log_p < rules::kLibraryLogP;
    decide(explanation.excess, fast, may_be_named, diagnosis);
    if (is_mainly_fast(diagnosis))
      diagnosis.late_ripples = find_late_ripples(series, fit.terms, fast.left);
  } else if (diagnosis.chance < rules::kFaintChance &&
             std::any_of(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                         [&](const auto& finding) { return helps_clearly(diagnosis, finding); })) {
    diagnosis.faint = true;
    diagnosis.verdict = Verdict::unknown;
  }
}

// Reservations about the answer.
std::vector<std::string> limits_of(const Diagnosis& diagnosis, bool noise_is_known) {
  std::vector<std::string> notes;
  if (diagnosis.candidates.empty()) {
    notes.emplace_back("these recordings can show none of the catalogue's effects");
  }
  if (!noise_is_known && !diagnosis.noise.from_quiet_parts && diagnosis.verdict != Verdict::none) {
    notes.emplace_back(
        "no part of these recordings is quiet (settled temperature, constant input rate), so that "
        "slow noise is not known: give a recording at rest with --static");
  }
  return notes;
}

// Slow noise hides slow effects; only a recording at rest determines it reliably.
std::string blind_spot_of(const Diagnosis& diagnosis, const series::Rows& rows,
                          bool noise_is_known) {
  if (diagnosis.verdict != Verdict::none) return "";
  const double floor = diagnosis.noise_floor_dph;
  const double above =
      std::sqrt(std::max(0.0, std::pow(diagnosis.residual_rms_dph, 2) - std::pow(floor, 2)));
  if (diagnosis.walk.may_be_all()) {
    return (above > std::sqrt(rules::kSmallExcess) * floor
                ? format("slow changes of %.3g deg/h rms are left; ", above)
                : "slow changes of less than a fifth of a row's noise are left; ") +
           diagnosis.walk.words();
  }
  if (diagnosis.chance < rules::kFaintChance) {
    return format(
        "more than noise is left, but only %.2g deg/h of it in %.3g: too little for these runs to "
        "judge what it is; a run of another programme, given with --holdout, may show more of it",
        above, diagnosis.residual_rms_dph);
  }
  if (noise_is_known || at_rest(rows)) return "";
  if (!diagnosis.noise.from_quiet_parts) {
    return "no part of them is quiet (settled temperature, constant input rate), so that slow "
           "noise is not known and may be a missing effect: a recording at rest, given with "
           "--static, would show it";
  }
  const double above_white = diagnosis.residual_rms_dph / diagnosis.noise.white_dph() - 1;
  if (above_white <= rules::kMuchAboveWhite) return "";
  return format(
      "what is left is %.0f %% above white noise, and only the soaks here say that this "
      "is slow noise of the gyro's own: a recording at rest, given with --static, would "
      "show it",
      100 * above_white);
}

// Where the residual is, and what may be missing. The columns of all explanations, most of a
// diagnosis' memory, live as long as this.
void look_for_causes(const model::Model& model, const DiagnosisData& data,
                     const fit::NoiseWeightedFit& fit, const DiagnosisSettings& settings,
                     Diagnosis& diagnosis) {
  const series::SignalSeries& series = data.series();
  // Candidates take most of the time, the test against noise the rest.
  constexpr double kCandidates = 0.75;
  const EvidenceSpace evidence = make_evidence_space(data, fit, [&](double done) {
    if (settings.progress) settings.progress(kCandidates * done);
  });
  diagnosis.untestable = evidence.untestable;
  ResidualPlace place = place_of(evidence.smooth, evidence.residual(), data.segments());
  diagnosis.variable = std::move(place.variable);
  diagnosis.variables = std::move(place.variables);
  diagnosis.segments = std::move(place.segments);
  if (!evidence.regressors.empty()) judge(evidence, series, fit, settings.seed, diagnosis);
  diagnosis.walk.has_static = settings.noise.has_value();
  if (model.network.present()) {
    diagnosis.network =
        ask_network(model.network, series, evidence.candidates,
                    [&](const Eigen::MatrixXd& columns) { return evidence.residualizer(columns); });
  }
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
  diagnosis.terms = fitted_terms(fit, rows.row_s);
  diagnosis.residual_rms_dph = rms_of_rows(rows, fit, fit.residual_dph);
  diagnosis.outliers = fit.outliers;
  diagnosis.residual_dph = fit.residual_dph;
  diagnosis.noise_floor_dph = data.noise_floor_dph().value_or(fit.noise.white_dph());

  look_for_causes(model, data, fit, settings, diagnosis);
  if (diagnosis.verdict == Verdict::ambiguous) {
    diagnosis.experiment = experiment_for_rivals(model, diagnosis);
  }
  diagnosis.notes = limits_of(diagnosis, settings.noise.has_value());
  diagnosis.blind_spot = blind_spot_of(diagnosis, rows, settings.noise.has_value());
  return diagnosis;
}

}  // namespace fogcomp::diagnosis
