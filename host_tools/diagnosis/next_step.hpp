#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "fit/add_effect.hpp"
#include "fit/training_runs.hpp"

namespace fogcomp::diagnosis {

/// Something that was added to the model for a trial, judged as `add` judges it.
struct TriedAddition {
  std::vector<std::string> effects;  ///< each as fit::change_effect() takes it; or else
  std::string expression;            ///< `NAME = EXPRESSION`
  bool accepted = false;
  bool may_be_walk = false;  ///< a random walk of the bias would explain as much
  std::string reason;        ///< one line: why it is accepted or not
  double rms_after_dph = 0;  ///< out of sample
  double rms_before_dph = 0;
};

/// What to do about what a diagnosis found.
struct NextStep {
  /// Named, and with an event among them: only a fit finds when that was.
  std::vector<std::string> events;
  /// What holds out of sample: what the diagnosis names; else what describes best.
  std::optional<TriedAddition> addition;
  /// By name, where the catalogue explains what is left and only these together hold.
  std::vector<std::string> together;
  bool describes = false;  ///< the addition lowers the error, and says nothing of the cause
  std::vector<TriedAddition> refused;
  /// Formulas that could describe it, best first, with how likely each is the largest part.
  std::vector<NamedShare> forms;
  std::optional<Experiment> experiment;  ///< that would tell these apart
};

/// Tries what `diagnosis` names and, where it names nothing or that does not hold, the sets of
/// effects that explain most, and formulas over the signals that vary (formulas_over()). Nothing is
/// tried where nothing is missing, or where what is left is no function of the signals: a cycle, a
/// random walk, a step. `data` has the rows of `runs`.
NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, const fit::TrainingRuns& runs,
                        const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
