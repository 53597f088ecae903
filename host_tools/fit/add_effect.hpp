#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "fit/cross_validation.hpp"
#include "fit/decision_rules.hpp"
#include "fit/effect_change.hpp"
#include "fit/fit_model.hpp"
#include "fit/training_runs.hpp"
#include "fit/training_series.hpp"

namespace fogcomp::fit {

/// The model without the change, refitted to the training runs.
struct RefittedModel {
  std::shared_ptr<const TrainingSeries> series;  ///< of these runs
  model::Model model;
  noise::NoiseModel noise{};  ///< as Identification has them
  Eigen::VectorXd row_weights{};
};

struct AddSettings {
  bool run_offsets = false;  ///< as in IdentifySettings; for holdouts, too
  std::uint64_t seed = 1;    ///< of the network's initial weights
  /// Called with the fraction of the trainings done, 0..1; may be empty.
  std::function<void(double)> progress{};
  /// Compute only verdict and model; skip what is printed beside them (halves, comparisons on the
  /// training runs, parts of a set except those that fail).
  bool verdict_only = false;
  /// Of refitted(), for several trials with one model and the same runs.
  const RefittedModel* before = nullptr;
};

/// A model with added or changed effects, and the verdict on them.
struct Addition {
  struct RunError {
    std::string file;
    bool holdout = false;
    double rms_before_dph = 0;  ///< of the whole model, network included, rows of average_s
    double rms_after_dph = 0;
    std::optional<double> noise_floor_dph;
    /// Fraction of the rows outside the new model's trained temperatures, 0..1. There a holdout
    /// judges the held value at the edge, not the effect.
    double outside_temperature = 0;
    compare::Comparison before;  ///< row by row
    compare::Comparison after;
  };
  /// One of several effects that were added together.
  struct Part {
    std::string effect;
    std::optional<OutOfSample> alone;   ///< without the others; nothing if not determined
    std::optional<OutOfSample> beside;  ///< when the others are already there
  };
  model::Model model;                ///< as refitted, with its history
  std::vector<std::size_t> changed;  ///< terms added or changed; empty for a network
  std::vector<Part> parts;           ///< of a set, in the order of `changed`; empty for one effect
  FitResult fit;                     ///< of the new model
  std::vector<RunError> runs;        ///< training runs, then holdouts
  /// The effects alone, before against after; for a network, the model with it against that
  /// without. Nothing for an event, or if the training was interrupted.
  std::optional<OutOfSample> out_of_sample;
  /// Without another run as judge: probability, 0..1, that a random walk of the bias explains what
  /// the addition explains. The stretches of one run lie between others of the same walk.
  std::optional<double> chance_of_walk;
  std::vector<HalfTest> halves;  ///< the same on the halves of the training runs; for information
  bool accepted = false;
  std::string reason;        ///< one line: why it is accepted or not
  bool may_be_line = false;  ///< refused because a line in time would do as well

  std::vector<std::string> names() const;  ///< of the additions and changes
};

/// `model` refitted to the training runs without any change. `series`: theirs, if there is one of a
/// model with the same averaging and derivative. Throws InputError like add_effect().
RefittedModel refitted(const model::Model& model, const TrainingRuns& training,
                       const AddSettings& settings,
                       std::shared_ptr<const TrainingSeries> series = nullptr);

/// Applies `change` to `model`, for whose terms it was made, and refits everything on `training`:
/// all effects together, then, if the model has a network, a new one of the same size on their
/// residual. "Before" is the model without the change, refitted on the same runs, so that refitting
/// alone is no improvement.
///
/// The change is accepted if all of this holds. The effects alone improve the prediction out of
/// sample (OutOfSample::helps): on the holdouts or, without any, by cross-validation. The whole
/// model's rms on the holdouts has not risen by more than chance. With stretches of one run, a
/// random walk of the bias is unlikely (rules::kMaxChanceOfWalk). The data determine the new parts:
/// no shape at a bound or anywhere in its range, coefficients larger than their uncertainty, a
/// drift in the soaks that is not less certain than it is large (Model::uncertain). In a set, each
/// effect helps beside the others. An event has no other run or stretch to judge it: it is accepted
/// if the search finds it (fit_with_steps()), and the rows around it are masked. A network replaces
/// the model's own; it is compared with the effects alone. Throws InputError for a run without an
/// input of the effect, for data that cannot determine it, and for an event that is not found.
Addition add_effect(const model::Model& model, const EffectChange& change,
                    const TrainingRuns& training, const std::vector<compare::RunInBlocks>& holdouts,
                    const AddSettings& settings);

}  // namespace fogcomp::fit
