#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "diagnosis/explanation.hpp"
#include "diagnosis/hypotheses.hpp"
#include "diagnosis/null_test.hpp"
#include "diagnosis/refit.hpp"
#include "diagnosis/structure.hpp"
#include "diagnosis/two_levels.hpp"
#include "diagnosis/visible_part.hpp"
#include "identification/explained_space.hpp"
#include "identification/noise_weighted_fit.hpp"
#include "identification/outlier_rows.hpp"
#include "identification/quiet_rows.hpp"
#include "identification/random_walk.hpp"
#include "identification/walk_rival.hpp"
#include "model/catalogue.hpp"
#include "numerics/decompositions.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

// Chances that noise alone is called a fault. Small where a single shape or line decides, because
// no gyro is quite what its noise and its model say: at a chance of 1 % every twentieth faultless
// simulated gyro was beyond it. Smooth structure is a sum over many directions: of 548 tests on
// faultless gyros, half of them with a recording at rest, the least chance was 2 %.
const double kLibraryLogP = std::log(0.0001);
const double kStructureLogP = std::log(0.01);
const double kFastLogP = std::log(0.0005);

// Of a row's noise variance: one recording cannot tell what is smaller, a fifth of the noise, from
// noise that is slower than its soaks.
constexpr double kSmallExcess = 0.2 * 0.2;
constexpr double kConfusable = 0.05;     // probability of an effect that it may be
constexpr double kPossible = 9;          // fall of chi^2 by which a shape is not the best
constexpr Eigen::Index kLeastRows = 60;  // for any opinion
constexpr double kEnoughFreedom = 12;    // of the noise: from soaks alone
constexpr double kMuchAboveWhite = 0.1;  // of the white noise: what a model leaves

class Diagnoser {
 public:
  Diagnoser(const Model& model, const DiagnosisData& data, const DiagnosisSettings& settings)
      : model_(model), data_(data), rows_(data.series().rows()), settings_(settings) {
    if (rows_.size() < kLeastRows) {
      throw InputError("diagnose",
                       format("%s of %g s: too few; at least %td are needed: "
                              "use a longer recording or a shorter --average",
                              counted(static_cast<std::size_t>(rows_.size()), "row").c_str(),
                              rows_.row_s, kLeastRows));
    }
    const Eigen::MatrixXd offsets = run_offset_columns(rows_);
    fit_ = fit_rows(data.series(), model.terms, offsets, {{}, settings.noise});
    if (!settings.noise && fit_.noise.freedom < kEnoughFreedom) {
      fit_ = fit_rows(data.series(), fit_.terms, offsets, {{}, noise_with_less_quiet()});
    }
  }

  Diagnosis run() {
    result_.rows = rows_.size();
    result_.row_s = rows_.row_s;
    result_.noise = fit_.noise;
    weigh_terms();
    result_.residual_rms_dph = rms(fit_.residual_dph);
    result_.outliers = fit_.outliers;
    result_.residual_dph = fit_.residual_dph;
    result_.noise_floor_dph = data_.noise_floor_dph().value_or(fit_.noise.white_dph());

    const ModelRemover remover(rows_, fit_);
    const ToVisible to_visible = [&](const Eigen::MatrixXd& columns) { return remover(columns); };
    // Candidates take most of the time, then the test against noise.
    constexpr double kCandidates = 0.75;
    CandidateList list =
        find_candidates(data_.series(), fit_.terms, data_.offered(), data_.inputs(), to_visible,
                        [&](double done) { tell(kCandidates * done); });
    tell(kCandidates);
    result_.untestable = list.untestable;
    candidates_ = std::move(list.testable);
    sharpen(candidates_, data_.series(), fit_.terms, to_visible, remover.residual());
    const VisibleStructure structure = visible_structure(rows_, remover);

    ExplainedSpace space(remover.residual());
    for (const Candidate& candidate : candidates_) {
      library_.emplace_back();
      for (const Candidate::Shape& shape : candidate.shapes) {
        library_.back().push_back(space.add(shape.basis));
      }
    }
    structure_ = space.add(structure.all);
    walk_ = add_walk(space, remover(random_walk_modes(rows_)).columns);
    space.finish();

    describe_where(structure, remover.residual());
    judge(space, structure, remover.residual());
    if (model_.network.present()) {
      result_.network = ask_network(model_.network, data_.series(), candidates_, to_visible);
    }
    const double above_white = result_.residual_rms_dph / fit_.noise.white_dph() - 1;
    if (result_.verdict == Verdict::none && fit_.noise.from_quiet_parts && !settings_.noise &&
        above_white > kMuchAboveWhite && !at_rest()) {
      result_.notes.push_back(
          format("what is left is %.0f %% above white noise, and only the soaks here say that this "
                 "is slow noise of the gyro's own: a recording at rest, given with --static, would "
                 "settle it",
                 100 * above_white));
    }
    if (!fit_.noise.from_quiet_parts && !settings_.noise) {
      result_.notes.emplace_back(
          "no part of these recordings is quiet (settled temperature), so that slow noise is not "
          "known: give a recording at rest with --static");
    }
    return std::move(result_);
  }

 private:
  void tell(double done) const {
    if (settings_.progress) settings_.progress(done);
  }

  // Where there is too little quiet to know the slow noise from, the faster part of everything
  // else helps: what smooth functions of any kind leave of it.
  NoiseModel noise_with_less_quiet() const {
    // Smooth functions reach 8 periods in a run and take some of what is beyond with them. Without
    // any quiet part a guess that is too low is better than one that takes all drift for noise.
    const std::size_t first_frequency = fit_.noise.from_quiet_parts ? 16 : 8;
    std::vector<Eigen::MatrixXd> parts{fit_.columns};
    for (StructureGroup& group : structure_groups(rows_)) parts.push_back(std::move(group.columns));
    const LinearFit smooth = solve_linear(side_by_side(parts, rows_.size()), rows_.drift_dph);
    const Eigen::VectorXd rest = bridged(rows_, smooth.residual, fit_.robust);
    const Eigen::VectorXd residual = bridged(rows_, fit_.residual_dph, fit_.robust);
    std::vector<NoiseSample> samples = noise_samples(quiet_stretches(rows_, residual));
    for (const RowRange& run : rows_.runs()) {
      samples.push_back({rest.segment(static_cast<Eigen::Index>(run.first),
                                      static_cast<Eigen::Index>(run.size())),
                         first_frequency});
    }
    NoiseModel noise = fit_noise(samples, rows_.row_s, longest_run_s(rows_));
    noise.from_quiet_parts = fit_.noise.from_quiet_parts;
    return noise;
  }

  double rms(const Eigen::VectorXd& residual) const {
    const Eigen::VectorXd weights = counted_weights(rows_, fit_.row_weights);
    return std::sqrt(residual.cwiseAbs2().dot(weights) / weights.sum());
  }

  // Whether these are recordings at rest themselves.
  bool at_rest() const {
    constexpr double kNearlyAll = 0.9;
    double quiet = 0;
    for (const Eigen::VectorXd& stretch : quiet_stretches(rows_, fit_.residual_dph)) {
      quiet += static_cast<double>(stretch.size());
    }
    return quiet > kNearlyAll * static_cast<double>(rows_.size());
  }

  // On what it depends and where it sits, by what smooth functions can describe of it.
  void describe_where(const VisibleStructure& structure, const Eigen::VectorXd& residual) {
    double most = 0;
    for (std::size_t i = 0; i < structure.groups.size(); ++i) {
      const Eigen::VectorXd along = structure.groups[i].transpose() * residual;
      const double evidence = log_evidence(along.squaredNorm(), static_cast<double>(along.size()));
      result_.variables.push_back({structure.variables[i], evidence});
      if (evidence <= most) continue;
      most = evidence;
      result_.variable = structure.variables[i];
    }
    for (Diagnosis::Share& share : result_.variables)
      share.share = most > 0 ? share.share / most : 0;
    const Eigen::VectorXd smooth = structure.all * (structure.all.transpose() * residual);
    double sum = 0;
    for (const DiagnosisData::Segment& segment : data_.segments()) {
      const double part = smooth.segment(segment.first, segment.end - segment.first).squaredNorm();
      result_.segments.push_back({segment.name, part});
      sum += part;
    }
    for (Diagnosis::Share& segment : result_.segments) segment.share /= sum > 0 ? sum : 1;
  }

  void judge(const ExplainedSpace& space, const VisibleStructure& structure,
             const Eigen::VectorXd& residual) {
    if (library_.empty()) {
      result_.notes.emplace_back("these recordings can show none of the catalogue's effects");
      return;
    }
    const NullTest test =
        test_against_noise(space, library_, structure_, fit_.noise.freedom, settings_.seed);
    const std::vector<Hypothesis> hypotheses = find_hypotheses(space, candidates_, library_);
    if (hypotheses.empty()) return;
    const Explanation explanation = explain(space, library_, structure_, hypotheses);
    result_.unexplained_fraction = explanation.unexplained;
    result_.fast =
        find_fast_structure(rows_, without(space, structure, *explanation.best, residual));
    result_.jumps = find_two_levels(quiet_stretches(rows_, quiet_values(*explanation.best)),
                                    fit_.noise.white_dph(), rows_.row_s);
    const double fast_log_p = weigh_fast();
    result_.chance = std::exp(std::min({test.library_log_p, test.structure_log_p, fast_log_p}));
    result_.tests = {test.library_log_p, test.structure_log_p, fast_log_p};
    bool slow = test.library_log_p < kLibraryLogP || test.structure_log_p < kStructureLogP;
    if (slow) result_.walk = weigh_walk(space, hypotheses);
    const bool small = explanation.excess < kSmallExcess * static_cast<double>(rows_.size());
    if (slow && small && result_.walk.chance >= kMaxChanceOfWalk) {
      slow = false;
      result_.chance = std::min(result_.walk.noise_alone, std::exp(fast_log_p));
    }
    const bool something = slow || fast_log_p < kFastLogP;

    weigh_effects(space, hypotheses, explanation.excess, something);
    list_explanations(hypotheses, explanation.excess);
    if (!something) return;
    const double fast_gain = fast_excess();
    const bool fast_left = fast_gain > kMostUnexplained[0] * (fast_gain + explanation.excess);
    if (!fast_left) result_.fast_kind = FastKind::none;
    if (fast_left && fast_gain > explanation.excess) result_.variable = "time_s";
    const bool physical = result_.walk.chance < kMaxChanceOfWalk;
    if (explanation.enough && !fast_left && physical && test.library_log_p < kLibraryLogP) {
      name_effects();
    } else {
      result_.verdict = Verdict::unknown;
    }
  }

  // What a hypothesis leaves, in rows of equal noise; NaN where a row does not count.
  Eigen::VectorXd quiet_values(const Hypothesis& hypothesis) const {
    const Eigen::ArrayXd scaled =
        refitted(hypothesis).residual_dph.array() / fit_.noise_scale.array();
    return (fit_.robust.array() > 0).select(scaled, std::nan(""));
  }

  // How likely all that is slow is a random walk of the bias: no effect and no smooth structure
  // stands out of noise that walks, and none is likelier.
  Diagnosis::RandomWalk weigh_walk(const ExplainedSpace& space,
                                   const std::vector<Hypothesis>& hypotheses) const {
    // Without quiet parts nothing is known of slow noise, and anything could be a walk.
    if (!fit_.noise.from_quiet_parts) return {};
    const WalkRival rival = find_walk(space, walk_, fit_.noise.walks);
    if (rival.coefficient == 0) return {};
    const NullTest test =
        test_against_noise(rival.space, library_, structure_, fit_.noise.freedom, settings_.seed);
    if (test.library_log_p < kLibraryLogP || test.structure_log_p < kStructureLogP) return {};
    std::vector<Explanatory> alone = explanatory(hypotheses);
    alone.push_back(
        {log_evidence(space.gain({structure_}), static_cast<double>(structure_.count)), 0});
    return {rival.coefficient,
            chance_of_walk(rival, alone,
                           explanatory(find_hypotheses(rival.space, candidates_, library_))),
            std::exp(std::min(test.library_log_p, test.structure_log_p))};
  }

  // One effect of the library is as likely to be missing as none.
  std::vector<Explanatory> explanatory(const std::vector<Hypothesis>& hypotheses) const {
    const double each = -std::log(static_cast<double>(library_.size()));
    std::vector<Explanatory> all;
    for (const Hypothesis& h : hypotheses) all.push_back({h.log_evidence, h.log_prior + each});
    return all;
  }

  // Which fast structure is the surest; returns the logarithm of its chance.
  double weigh_fast() {
    const std::array<std::pair<double, FastKind>, 3> kinds{
        {{result_.fast.line_log_p, FastKind::line},
         {result_.fast.band_log_p, FastKind::band},
         {-result_.jumps.log_odds, FastKind::two_levels}}};
    const auto& [log_p, kind] = *std::min_element(kinds.begin(), kinds.end());
    if (log_p < kFastLogP) result_.fast_kind = kind;
    return log_p;
  }

  // chi^2 above noise that it brings.
  double fast_excess() const {
    switch (result_.fast_kind) {
      case FastKind::none:
        return 0;
      case FastKind::line:
      case FastKind::band:
        return result_.fast.share * static_cast<double>(rows_.size());
      case FastKind::two_levels:
        break;
    }
    return result_.jumps.gain;
  }

  // The residual without what a hypothesis and smooth functions explain of it.
  Eigen::VectorXd without(const ExplainedSpace& space, const VisibleStructure& structure,
                          const Hypothesis& hypothesis, const Eigen::VectorXd& residual) const {
    std::vector<ColumnRange> ranges = ranges_of(library_, hypothesis);
    ranges.push_back(structure_);
    const Eigen::VectorXd coefficients = space.coefficients(ranges);
    Eigen::VectorXd left = residual;
    Eigen::Index at = 0;
    for (const Hypothesis::Part& part : hypothesis.parts) {
      const Eigen::MatrixXd& basis = candidates_[part.candidate].shapes[part.shape].basis;
      left -= basis * coefficients.segment(at, basis.cols());
      at += basis.cols();
    }
    left -= structure.all * coefficients.tail(structure.all.cols());
    return left.head(rows_.size());
  }

  void list_explanations(const std::vector<Hypothesis>& hypotheses, double excess) {
    for (std::size_t i = 0; i < std::min<std::size_t>(6, hypotheses.size()); ++i) {
      Diagnosis::Explanation entry;
      for (const Hypothesis::Part& part : hypotheses[i].parts) {
        entry.effects.push_back(candidates_[part.candidate].effect);
      }
      entry.probability = hypotheses[i].probability;
      entry.explained_fraction =
          excess > 0
              ? std::clamp((hypotheses[i].gain - column_count(ranges_of(library_, hypotheses[i]))) /
                               excess,
                           0.0, 1.0)
              : 0;
      result_.explanations.push_back(std::move(entry));
    }
  }

  void weigh_effects(const ExplainedSpace& space, const std::vector<Hypothesis>& hypotheses,
                     double excess, bool something) {
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      CandidateFinding finding;
      finding.effect = candidates_[i].effect;
      const BestShape best = best_shape(space, library_[i], {}, space.along());
      std::size_t shape = best.shape;
      bool seen = false;
      for (const Hypothesis& hypothesis : hypotheses) {
        if (!hypothesis.has(i)) continue;
        finding.probability += hypothesis.probability;
        if (leading_candidate(space, library_, hypothesis) == i) {
          finding.lead += hypothesis.probability;
        }
        if (!seen) {
          for (const Hypothesis::Part& part : hypothesis.parts) {
            if (part.candidate == i) shape = part.shape;
          }
        }
        seen = true;
      }
      const ColumnRange& range = library_[i][shape];
      finding.evidence = best.log_evidence;
      finding.explained_fraction =
          excess > 0 ? std::clamp((best.gain - static_cast<double>(range.count)) / excess, 0.0, 1.0)
                     : 0;
      const double all_but = best.gain - kPossible * (1 + kModelFormTolerance * best.gain);
      for (std::size_t s = 0; s < library_[i].size(); ++s) {
        if (s != shape && space.gain({library_[i][s]}) < all_but) continue;
        finding.possible.push_back(candidates_[i].shapes[s].term);
      }
      std::vector<EffectTerm> terms = fit_.terms;
      put(terms, candidates_[i].shapes[shape].term);
      Refit completed = refit(std::move(terms), data_.series(), fit_);
      finding.rms_after_dph = rms(completed.residual_dph);
      finding.completed = std::move(completed.terms);
      if (!something) {
        const double believed =
            std::min(1.0, std::exp(finding.evidence) / 20) * (1 - result_.walk.chance);
        finding.probability *= believed;
        finding.lead *= believed;
      }
      result_.candidates.push_back(std::move(finding));
    }
    std::stable_sort(result_.candidates.begin(), result_.candidates.end(),
                     [](const CandidateFinding& a, const CandidateFinding& b) {
                       return std::make_tuple(a.lead, a.probability, a.evidence) >
                              std::make_tuple(b.lead, b.probability, b.evidence);
                     });
  }

  // The model with the effects of a hypothesis, and what it leaves of each row.
  Refit refitted(const Hypothesis& hypothesis) const {
    std::vector<EffectTerm> terms = fit_.terms;
    for (const Hypothesis::Part& part : hypothesis.parts) {
      put(terms, candidates_[part.candidate].shapes[part.shape].term);
    }
    return refit(std::move(terms), data_.series(), fit_);
  }

  // What each term of the model is worth.
  void weigh_terms() {
    result_.terms = fit_.terms;
    const std::vector<ColumnRange> columns = columns_of(fit_.terms, rows_.row_s);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto [first, count] = columns[i];
      const Eigen::VectorXd own = fit_.coefficients.segment(first, count);
      result_.terms[i].coefficients_dph.assign(own.begin(), own.end());
      result_.term_gain.push_back(
          fit_.covariance.size() == 0
              ? 0
              : own.dot(solve_definite(fit_.covariance.block(first, first, count, count), own)));
    }
  }

  // Several effects may be missing at once; the question is which brings most.
  void name_effects() {
    const CandidateFinding& first = result_.candidates.front();
    if (first.probability >= kNamed) {
      result_.verdict = Verdict::missing_effect;
      result_.effect = first.effect;
      return;
    }
    result_.verdict = Verdict::ambiguous;
    for (const CandidateFinding& finding : result_.candidates) {
      if (finding.lead >= kConfusable) result_.confusable.push_back(finding.effect);
    }
    result_.experiment = experiment_for_rivals();
  }

  // What would tell the most probable rivals apart.
  Experiment experiment_for_rivals() const {
    constexpr std::size_t kMostRivals = 3;
    std::vector<Rival> rivals;
    bool event = false;
    for (const std::string& effect : result_.confusable) {
      if (rivals.size() == kMostRivals) break;
      const CandidateFinding& finding = *result_.find(effect);
      if (is_event(finding.term())) {
        event = true;
        continue;
      }
      rivals.push_back({effect, finding.completed, finding.possible});
    }
    if (rivals.size() > 1) return propose_experiment(model_, rivals, fit_.noise);
    Experiment repeat;
    if (event) repeat.sentence = "record the same programme again: an event does not come back";
    return repeat;
  }

  const Model& model_;
  const DiagnosisData& data_;
  const Rows& rows_;
  const DiagnosisSettings& settings_;
  NoiseWeightedFit fit_;
  std::vector<Candidate> candidates_;
  Library library_;
  ColumnRange structure_;
  WalkModes walk_;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const Model& model, const DiagnosisData& data,
                   const DiagnosisSettings& settings) {
  return Diagnoser(model, data, settings).run();
}

}  // namespace fogcomp
