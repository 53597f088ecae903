#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "fit/decision_rules.hpp"
#include "fit/effect_change.hpp"
#include "fit/fit_model.hpp"
#include "fit/out_of_sample.hpp"
#include "fit/training_runs.hpp"

namespace fogcomp::fit {

/// The model as it was, refitted to some rows.
struct RefittedModel {
  Eigen::VectorXd drift_dph;  ///< of the rows
  model::Model model;
};

struct AddSettings {
  bool run_offsets = false;  ///< as IdentifySettings has it; holdouts too
  std::uint64_t seed = 1;    ///< of the network's first weights
  /// Told how much of its trainings is done, 0..1; or empty.
  std::function<void(double)> progress{};
  /// For a trial: what is told beside the verdict (halves, comparisons on the training runs, parts
  /// of a set but what speaks against it) is left out. The model is the same.
  bool verdict_only = false;
  /// Of trials with one model and the same runs: kept from one to the next.
  RefittedModel* before = nullptr;
};

/// A model with some effects more, or changed, and whether that was worth it.
struct Addition {
  struct RunError {
    std::string file;
    bool holdout = false;
    double rms_before_dph = 0;  ///< of the whole model, network included, rows of average_s
    double rms_after_dph = 0;
    std::optional<double> noise_floor_dph;
    /// Part of the rows outside the new model's trained temperatures, 0..1: there a holdout judges
    /// how the board holds the drift, not the effect.
    double outside_temperature = 0;
    compare::Comparison before;  ///< row by row
    compare::Comparison after;
  };
  /// One of several effects that were added together.
  struct Part {
    std::string effect;
    std::optional<OutOfSample> alone;   ///< without the others; nothing: not determined so
    std::optional<OutOfSample> beside;  ///< when the others are there already
  };
  model::Model model;                ///< as refitted, with its history
  std::vector<std::size_t> changed;  ///< the terms that were added or changed; none: a network
  std::vector<Part> parts;           ///< of a set, as `changed`; empty for one effect
  FitResult fit;                     ///< of the new model
  std::vector<RunError> runs;        ///< training runs, then holdouts
  /// The effects alone, before against after; of a network the model with it against that without.
  /// Nothing for an event, or where the training was interrupted.
  std::optional<OutOfSample> out_of_sample;
  /// Where no other run judged: chance that a random walk of the bias, and no effect, is what the
  /// addition explains, 0..1. Stretches of one run lie between others that walked along.
  std::optional<double> chance_of_walk;
  std::vector<HalfTest> halves;  ///< the same on the halves of the training runs; for information
  bool accepted = false;
  std::string reason;  ///< one line: why it is accepted or not

  std::vector<std::string> names() const;  ///< of what was added or changed
};

/// Makes `change` to the terms of `model`, from which it was made, and refits everything on
/// `training`: all effects together, then, if the model has a network, a new one of the same size
/// on what they leave. "Before" is the model without the change, refitted on the same runs, so that
/// refitting alone earns nothing.
///
/// Accepted if the effects alone gain out of sample (OutOfSample::helps): on the holdouts, or where
/// there are none on stretches or runs left out; and if the whole model's rms on the holdouts has
/// not risen beyond chance; on stretches of one run, if a random walk of the bias is unlikely, too
/// (rules::kMaxChanceOfWalk); and if the data determine what is new: no shape at a bound or
/// anywhere within its range, a coefficient larger than its uncertainty; and of several, if each
/// helps beside the others. An event has no other run or stretch that could judge it: it is
/// accepted where the search finds it (fit_with_steps()), and the rows around it are masked. A
/// network replaces the one that the model has; it is judged against the effects alone. Throws
/// InputError for a run that lacks what the effect needs, for data that cannot determine it, and
/// for an event that is not found.
Addition add_effect(const model::Model& model, const EffectChange& change,
                    const TrainingRuns& training, const std::vector<compare::RunInBlocks>& holdouts,
                    const AddSettings& settings);

}  // namespace fogcomp::fit
