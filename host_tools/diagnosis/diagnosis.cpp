#include "diagnosis/diagnosis.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "dataset/segments.hpp"
#include "diagnosis/explained_space.hpp"
#include "diagnosis/hypotheses.hpp"
#include "diagnosis/null_test.hpp"
#include "diagnosis/visible_part.hpp"
#include "evaluation/noise_floor.hpp"
#include "identification/noise_weighted_fit.hpp"
#include "identification/required_inputs.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

// Chances, together 1 %, that a run without any fault is called faulty.
const double kLibraryLogP = std::log(0.006);
const double kStructureLogP = std::log(0.002);
const double kFastLogP = std::log(0.001);

constexpr double kNamed = 0.95;          // probability from which one name is given
constexpr double kConfusable = 0.05;     // and from which an effect is among those that it may be
constexpr double kUnexplained = 0.12;    // of the excess: more than that is no catalogued effect
constexpr double kLeftoverLogP = -7;     // that what is left over is noise
constexpr Eigen::Index kLeastRows = 60;  // for any opinion

// Smooth structure as orthonormal columns, group by group and together.
struct Structure {
  std::vector<std::string> variables;
  std::vector<Eigen::MatrixXd> groups;
  Eigen::MatrixXd all;
};

Eigen::MatrixXd principal(const Eigen::MatrixXd& columns) {
  constexpr double kLeast = 1e-3;  // of a unit column: what is less is all but invisible
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(columns.transpose() * columns);
  Eigen::Index kept = 0;
  while (kept < columns.cols() && eigen.eigenvalues()[columns.cols() - 1 - kept] > kLeast) ++kept;
  const Eigen::MatrixXd directions = eigen.eigenvectors().rightCols(kept);
  const Eigen::VectorXd scale = eigen.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse();
  return columns * directions * scale.asDiagonal();
}

Structure find_structure(const Rows& rows, const ModelRemover& remover) {
  Structure structure;
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index width = 0;
  for (const StructureGroup& group : structure_groups(rows)) {
    const VisiblePart part = remover(group.columns);
    Eigen::MatrixXd kept(part.columns.rows(), part.columns.cols());
    Eigen::Index count = 0;
    for (Eigen::Index i = 0; i < part.columns.cols(); ++i) {
      constexpr double kLeastVisible = 0.01;
      if (part.visible[i] > kLeastVisible) kept.col(count++) = part.columns.col(i).normalized();
    }
    if (count == 0) continue;
    structure.variables.push_back(group.variable);
    structure.groups.push_back(principal(kept.leftCols(count)));
    parts.push_back(kept.leftCols(count));
    width += count;
  }
  Eigen::MatrixXd all(remover.residual().size(), width);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  structure.all = principal(all);
  return structure;
}

// ln of the chance that `columns` of white noise gain as much: Wilson and Hilferty's cube root.
double chi_square_log_p(double gain, double columns) {
  if (columns < 1) return 0;
  const double variance = 2 / (9 * columns);
  const double z =
      (std::cbrt(std::max(gain, 0.0) / columns) - (1 - variance)) / std::sqrt(variance);
  return z < 1 ? 0 : -z * z / 2 - std::log(z * 2.5066);
}

class Diagnoser {
 public:
  Diagnoser(const Model& model, const DiagnosisData& data, const DiagnosisSettings& settings)
      : data_(data), rows_(data.series().rows()), settings_(settings) {
    if (rows_.size() < kLeastRows) {
      throw InputError("diagnose", format("%td rows of %g s are too few; at least %td are needed: "
                                          "use a longer recording or a shorter --average",
                                          rows_.size(), rows_.row_s, kLeastRows));
    }
    fit_ = fit_rows(data.series(), model.terms, run_offset_columns(rows_), settings.noise);
  }

  Diagnosis run() {
    result_.rows = rows_.size();
    result_.row_s = rows_.row_s;
    result_.noise = fit_.noise;
    result_.residual_rms_dph = rms(fit_.residual_dph);
    result_.noise_floor_dph = data_.noise_floor_dph().value_or(fit_.noise.white_dph());

    const ModelRemover remover(rows_, fit_);
    CandidateList list =
        find_candidates(data_.series(), fit_.terms, data_.inputs(),
                        [&](const Eigen::MatrixXd& columns) { return remover(columns); });
    result_.untestable = list.untestable;
    candidates_ = std::move(list.testable);
    const Structure structure = find_structure(rows_, remover);

    ExplainedSpace space(remover.residual());
    for (const Candidate& candidate : candidates_) {
      library_.emplace_back();
      for (const Candidate::Shape& shape : candidate.shapes) {
        library_.back().push_back(space.add(shape.columns));
      }
    }
    structure_ = space.add(structure.all);
    space.finish();

    describe_where(structure, remover.residual());
    judge(space, remover);
    if (!fit_.noise.from_quiet_parts && !settings_.noise) {
      result_.notes.emplace_back(
          "no part of these recordings is quiet (settled temperature), so that slow noise is not "
          "known: give a recording at rest with --static");
    }
    return std::move(result_);
  }

 private:
  double rms(const Eigen::VectorXd& residual) const {
    return std::sqrt(residual.cwiseAbs2().dot(rows_.weights) / rows_.weights.sum());
  }

  // On what it depends and where it sits, by what smooth functions can describe of it.
  void describe_where(const Structure& structure, const Eigen::VectorXd& residual) {
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

  double width(const std::vector<ColumnRange>& ranges) const {
    double columns = 0;
    for (const ColumnRange& range : ranges) columns += static_cast<double>(range.count);
    return columns;
  }
  std::vector<ColumnRange> ranges_of(const Hypothesis& hypothesis) const {
    std::vector<ColumnRange> ranges;
    for (const Hypothesis::Part& part : hypothesis.parts) {
      ranges.push_back(library_[part.candidate][part.shape]);
    }
    return ranges;
  }

  void judge(const ExplainedSpace& space, const ModelRemover& remover) {
    result_.fast = find_fast_structure(rows_, remover.residual().head(rows_.size()));
    if (library_.empty()) {
      result_.notes.emplace_back("these recordings can show none of the catalogue's effects");
      return;
    }
    const NullTest test =
        test_against_noise(space, library_, structure_, fit_.noise.freedom, settings_.seed);
    const double fast_log_p = std::min(result_.fast.line_log_p, result_.fast.band_log_p);
    result_.chance = std::exp(std::min({test.library_log_p, test.structure_log_p, fast_log_p}));
    const bool something = test.library_log_p < kLibraryLogP ||
                           test.structure_log_p < kStructureLogP || fast_log_p < kFastLogP;

    const std::vector<Hypothesis> hypotheses = find_hypotheses(space, candidates_, library_);
    if (hypotheses.empty()) return;
    const Hypothesis& best = hypotheses.front();
    std::vector<ColumnRange> with_structure = ranges_of(best);
    const double best_width = width(with_structure);
    with_structure.push_back(structure_);
    const double all = space.gain(with_structure);
    const double left = all - best.gain;
    const auto left_width = static_cast<double>(structure_.count);
    const double excess = std::max(all - left_width - best_width, best.gain - best_width);
    result_.unexplained_fraction =
        excess > 0 ? std::clamp((left - left_width) / excess, 0.0, 1.0) : 0;

    weigh_effects(space, hypotheses, excess, something);
    if (!something) return;
    // What is left is unknown if it is surely there and no small part of the whole.
    const bool smooth_left = chi_square_log_p(left, left_width) < kLeftoverLogP &&
                             result_.unexplained_fraction > kUnexplained;
    const double fast_gain = result_.fast.share * static_cast<double>(rows_.size());
    const bool fast_left =
        fast_log_p < kFastLogP && fast_gain > kUnexplained * (fast_gain + excess);
    if (smooth_left || fast_left || test.library_log_p > kLibraryLogP) {
      result_.verdict = Verdict::unknown;
      if (fast_left && fast_gain > excess) {
        result_.variable = "time_s";
      }
      return;
    }
    name_effects(hypotheses);
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
      finding.term = candidates_[i].shapes[shape].term;
      solve_with(finding);
      if (!something) finding.probability *= std::min(1.0, std::exp(finding.evidence) / 20);
      result_.candidates.push_back(std::move(finding));
    }
    std::stable_sort(result_.candidates.begin(), result_.candidates.end(),
                     [](const CandidateFinding& a, const CandidateFinding& b) {
                       return std::make_pair(a.probability, a.evidence) >
                              std::make_pair(b.probability, b.evidence);
                     });
  }

  // The effect's coefficients with the model's own refitted, and the rms that this leaves.
  void solve_with(CandidateFinding& finding) const {
    const Eigen::MatrixXd regressors = data_.series().regressors(finding.term);
    // Where the model has a smaller version of it, that one's columns are the first.
    Eigen::Index before = 0;
    Eigen::Index owned = 0;
    for (const EffectTerm& term : fit_.terms) {
      const Eigen::Index width = data_.series().regressors(term).cols();
      if (term.name == finding.effect) owned = width;
      if (owned > 0) break;
      before += width;
    }
    const Eigen::MatrixXd added = regressors.rightCols(regressors.cols() - owned);
    Eigen::MatrixXd columns(rows_.size(), fit_.linear() + added.cols());
    columns << fit_.columns, added;
    const Whitening whitening(fit_.noise, rows_, fit_.row_weights);
    const LinearFit fit = solve_linear(whitening.apply(columns), fit_.whitened_measured);
    finding.rms_after_dph = rms(rows_.drift_dph - columns * fit.coefficients);
    const auto own = fit.coefficients.segment(before, owned);
    const auto tail = fit.coefficients.tail(added.cols());
    finding.term.coefficients_dph.assign(own.begin(), own.end());
    finding.term.coefficients_dph.insert(finding.term.coefficients_dph.end(), tail.begin(),
                                         tail.end());
  }

  void name_effects(const std::vector<Hypothesis>& hypotheses) {
    const std::vector<CandidateFinding>& found = result_.candidates;
    if (found.front().probability >= kNamed) {
      // Several may be certain: the one that brings most comes first.
      const CandidateFinding* named = &found.front();
      for (const CandidateFinding& finding : found) {
        if (finding.probability >= kNamed && finding.evidence > named->evidence) named = &finding;
      }
      result_.verdict = Verdict::missing_effect;
      result_.effect = named->effect;
      return;
    }
    (void)hypotheses;
    result_.verdict = Verdict::ambiguous;
    for (const CandidateFinding& finding : found) {
      if (finding.probability >= kConfusable) result_.confusable.push_back(finding.effect);
    }
  }

  const DiagnosisData& data_;
  const Rows& rows_;
  const DiagnosisSettings& settings_;
  NoiseWeightedFit fit_;
  std::vector<Candidate> candidates_;
  Library library_;
  ColumnRange structure_;
  Diagnosis result_;
};

}  // namespace

void DiagnosisData::add(const Recording& recording) {
  const BlockSeries blocks = make_blocks(recording);
  const auto first_row = static_cast<std::size_t>(series_.rows().size());
  series_.add(blocks);
  inputs_ &= blocks.inputs;
  const Rows& rows = series_.rows();
  std::size_t first = first_row;
  for (const fogcomp::Segment& segment : find_segments(recording)) {
    const double end_s =
        segment.end_row < recording.rows() ? recording.time_s[segment.end_row] : HUGE_VAL;
    std::size_t end = first;
    while (end < rows.time_s.size() && rows.time_s[end] < end_s) ++end;
    if (end > first) {
      segments_.push_back(
          {segment.name, static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(end)});
    }
    first = end;
  }
  if (const auto floor = fogcomp::noise_floor_dph(recording, rows.row_s)) {
    const auto count = static_cast<double>(rows.time_s.size() - first_row);
    floor_square_rows_ += *floor * *floor * count;
    floor_rows_ += count;
  }
}

std::optional<double> DiagnosisData::noise_floor_dph() const {
  if (floor_rows_ == 0) return std::nullopt;
  return std::sqrt(floor_square_rows_ / floor_rows_);
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::missing_effect:
      return "missing_effect";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unknown:
      break;
  }
  return "unknown";
}

Diagnosis diagnose(const Model& model, const DiagnosisData& data,
                   const DiagnosisSettings& settings) {
  return Diagnoser(model, data, settings).run();
}

}  // namespace fogcomp
