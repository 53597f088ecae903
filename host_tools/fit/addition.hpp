#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "fit/cross_validation.hpp"
#include "fit/fit_model.hpp"
#include "fit/known_regressors.hpp"
#include "recording/mask.hpp"

namespace fogcomp::fit {

/// The model without the change, refitted to the training runs in the rows in which additions are
/// judged.
struct RefittedModel {
  std::shared_ptr<const KnownRegressors> series;  ///< of these runs
  model::Model model;
  noise::NoiseModel noise{};  ///< as Identification has them
  Eigen::VectorXd row_weights{};
};

struct AddSettings {
  bool run_offsets = false;  ///< as in IdentifySettings; for holdouts, too
  std::uint64_t seed = 1;    ///< of the network's initial weights
  /// Called with the fraction of the trainings done, 0..1; may be empty.
  std::function<void(double)> progress{};
  /// Compute only verdict and model; skip what is printed beside them (comparisons on the training
  /// runs, parts of a set except those that fail).
  bool verdict_only = false;
  /// Of refitted(), for several trials with one model and the same runs.
  const RefittedModel* before = nullptr;
};

/// The verdict on an addition.
struct AdditionVerdict {
  /// One of several effects that were added together.
  struct Part {
    std::string effect;
    std::optional<OutOfSample> alone;   ///< without the others; nothing if not determined
    std::optional<OutOfSample> beside;  ///< when the others are already there
  };
  double row_s = 0;  ///< rows in which it was judged (runs/run.hpp)
  /// In these rows, of the whole model: rms of the training runs.
  double fitted_before_dph = 0;
  double fitted_after_dph = 0;
  std::optional<OutOfSample> whole{};  ///< the whole model, network included, on the holdouts
  std::vector<Part> parts;  ///< of a set, in the order of Addition::changed; empty for one effect
  /// The effects alone, before against after; for a network, the model with it against that
  /// without. Nothing if the training was interrupted.
  std::optional<OutOfSample> out_of_sample;
  /// The same on rows unlike those that foretell them (far_parts()), which must not harm; empty
  /// where a holdout judges.
  std::vector<OutOfSample> far;
  bool accepted = false;
  std::string reason;      ///< one line: why it is accepted or not
  std::string needless{};  ///< refused for this effect of a set, which brings nothing beside
};

/// A model with added or changed effects, and the verdict on them.
struct Addition : AdditionVerdict {
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
  model::Model model;                  ///< as refitted, with its history
  std::vector<std::size_t> changed;    ///< terms added or changed; empty for a network or cuts
  std::vector<recording::Cut> cuts{};  ///< that were added instead
  FitResult fit;                       ///< of the new model
  std::vector<RunError> runs;          ///< training runs, then holdouts

  std::vector<std::string> names() const;  ///< of the additions and changes
  bool is_network() const { return changed.empty() && cuts.empty(); }
};

}  // namespace fogcomp::fit
