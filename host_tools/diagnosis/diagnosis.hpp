#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "diagnosis/candidate_finding.hpp"
#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/experiment.hpp"
#include "diagnosis/fast_finding.hpp"
#include "diagnosis/network_learnt.hpp"
#include "diagnosis/residual_place.hpp"
#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

enum class Verdict : std::uint8_t { none, missing_effect, ambiguous, unknown };
const char* name_of(Verdict verdict);

struct Diagnosis {
  Verdict verdict = Verdict::none;
  std::string effect;                        ///< the one named, "" unless missing_effect
  std::vector<std::string> confusable;       ///< best first, for ambiguous
  std::vector<CandidateFinding> candidates;  ///< the likeliest to be the largest first
  std::vector<Untestable> untestable;
  /// Competing sets of effects, most probable first.
  struct Explanation {
    std::vector<std::string> effects;
    double probability = 0;
    double explained_fraction = 0;
    double complete = 0;  ///< probability that it is all, with nothing else beside it
  };
  std::vector<Explanation> explanations;

  std::optional<Experiment> experiment;  ///< where effects are ambiguous
  /// If nothing is missing: why these recordings could not show an effect, and which would; "" if
  /// they could.
  std::string blind_spot;

  std::vector<model::EffectTerm> terms;  ///< of the model, refitted to these runs

  std::string variable;               ///< on which what is left depends most
  std::vector<NamedShare> variables;  ///< how much of it each variable alone could describe
  std::vector<NamedShare> segments;   ///< where in the runs it sits; sums to 1
  bool only_by_formula = false;       ///< for the verdict unknown: set by shown_by_formulas()
  /// For the verdict unknown: what was named until it was refused; else "".
  std::string withdrawn;
  FastStructure fast;
  TwoLevels jumps;
  FastKind fast_kind = FastKind::none;  ///< the surest of these, where it is sure and counts
  double fast_share = 0;                ///< its fraction of the excess; 0 if it does not count
  /// Where that is most of it: a ripple over a late temperature that may make it, for `add`.
  std::vector<std::string> late_ripples;

  double residual_rms_dph = 0;  ///< of a row, the model refitted to these runs
  /// Error of the given model on these runs, network included: what `compare` prints.
  std::optional<compare::BoardError> as_given;
  std::size_t outliers = 0;      ///< rows left out of all figures
  Eigen::VectorXd residual_dph;  ///< row by row
  double noise_floor_dph = 0;
  double unexplained_fraction = 0;   ///< of what is above the noise, by the best of the catalogue
  double nothing = 1;                ///< probability that nothing is missing
  double something_else = 0;         ///< that something is that is no effect of the catalogue
  double mostly_something_else = 0;  ///< and that this is most of it
  double walk_dph_per_rth = 0;       ///< random walk of the bias, if nothing is missing
  bool has_static = false;           ///< the noise is known from a recording at rest
  noise::NoiseModel noise;
  Eigen::Index rows = 0;
  double row_s = 0;
  std::optional<NetworkLearnt> network;  ///< of the model, if it has one
  std::vector<std::string> notes;        ///< whole sentences: what limits the answer

  /// Whether all that is left may be noise.
  bool may_be_noise() const;
  /// Whether no more is left than the noise that the recordings show from row to row. A random walk
  /// may explain more as well as an effect does; then one recording cannot tell.
  bool leaves_noise() const;
  /// Whether an effect is more probably the largest of what is missing than something else is.
  bool is_led_by_catalogue() const;
  /// That a random walk explains slow changes, "them", and what would tell.
  std::string walk_words() const;
  /// Finding for an effect; nullptr if it cannot be tested.
  const CandidateFinding* find(const std::string& name) const;
};

/// The most probable set of effects that lower the error only together; the first is the named one,
/// or the best of the indistinguishable ones. Empty if that one alone lowers the error.
std::vector<std::string> effects_together(const Diagnosis& diagnosis);

/// Effect to add: the named one; among indistinguishable ones the most probable, provided that it
/// lowers the error; if not
/// everything is understood, an effect that is certainly the main part and lowers the error; else
/// "".
std::string effect_to_add(const Diagnosis& diagnosis);

/// What that effect would remove from the residual of `data`, with all refitted: deg/h, row by row,
/// about the mean of each recording, whose bias is refitted, too. Empty if there is none to add.
Eigen::VectorXd removed_by_addition_dph(const Diagnosis& diagnosis, const DiagnosisData& data);

struct DiagnosisSettings {
  std::optional<noise::NoiseModel>
      noise;                 ///< from a static record; otherwise from the runs' quiet parts
  bool run_offsets = false;  ///< additions are judged with a bias of its own for each power-on
  /// Called with the fraction done, 0..1 (for a stepwise selection: of its maximum length); may be
  /// empty.
  std::function<void(double)> progress{};
};

/// Whether most of what is left is fast: a cycle, jumps.
bool is_mainly_fast(const Diagnosis& diagnosis);

/// Only formulas outside the catalogue show that something is missing: the verdict becomes unknown.
Diagnosis shown_by_formulas(Diagnosis diagnosis, double nothing);

/// Without a name that fails out of sample: the verdict becomes unknown.
Diagnosis without_name(Diagnosis diagnosis);

/// Decides whether the effects of `model` leave more than noise and, if so, which effect of the
/// catalogue or expression of data.offered() is missing. A network is left out; a separate step
/// reports what it had learnt. The coefficients are solved for again with every candidate. Throws
/// InputError for data too short for the model's effects.
Diagnosis diagnose(const model::Model& model, const DiagnosisData& data,
                   const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
