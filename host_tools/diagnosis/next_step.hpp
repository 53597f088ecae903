#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "fit/add_effect.hpp"
#include "fit/training_runs.hpp"

namespace fogcomp::diagnosis {

/// What `add` is told to add: effects, or an expression.
struct AdditionRequest {
  std::vector<std::string> effects;  ///< as fit::change_effects() takes them; or else
  std::string expression;            ///< `NAME = EXPRESSION`

  std::vector<std::string> names() const;  ///< without their parameters
  bool is_network() const;
};

/// An addition to the model that was tried, judged as `add` judges it.
struct TriedAddition {
  AdditionRequest request;
  bool accepted = false;
  bool may_be_walk = false;  ///< a random walk of the bias would explain as much
  std::string reason;        ///< one line: why it is accepted or not
  double rms_after_dph = 0;  ///< out of sample; both 0 for an event, which nothing else can judge
  double rms_before_dph = 0;
  /// As `add` makes it from a model without a network; where accepted.
  std::optional<model::Model> model;
};

/// A formula that could describe what is left.
struct Form {
  std::string text;        ///< as a reader wants it: lag(dTdt^2,tau)
  std::string expression;  ///< `NAME = EXPRESSION` with the bounds of its parameters, for `add`
  double share = 0;        ///< how likely it is the largest part
};

/// What to do about what a diagnosis found.
struct NextStep {
  /// What holds out of sample: what the diagnosis names; else what describes best.
  std::optional<TriedAddition> addition;
  /// By name, where the catalogue explains what is left and only these together hold.
  std::vector<std::string> together;
  bool describes = false;  ///< the addition lowers the error, and says nothing of the cause
  std::vector<TriedAddition> refused;
  /// All that is left, beside what was taken out, may be the inexactness of what is there: nothing
  /// is tried.
  bool little_is_left = false;
  std::vector<Form> forms;               ///< best first
  std::optional<Experiment> experiment;  ///< that would tell these apart
};

/// The runs by which additions are judged: those to be fitted to and, where there are some, others
/// that decide.
struct JudgingRuns {
  fit::TrainingRuns training;
  std::vector<compare::RunInBlocks> holdouts;

  /// With one of the training runs as the holdout.
  JudgingRuns without(std::size_t run) const;
};

/// As the command `add` does it, its network included, for the verdict and the model alone.
/// `before`: as AddSettings has it. Throws InputError as fit::add_effect() does.
fit::Addition try_to_add(const model::Model& model, const AdditionRequest& request,
                         const JudgingRuns& runs, fit::RefittedModel* before = nullptr);

/// Tries what `diagnosis` names and, where it names nothing or that does not hold, the sets of
/// effects that explain most, and formulas over the signals that vary (formulas_over()). What holds
/// also has to lower the error of the training runs and, where no holdout judges, by no less than
/// rules::kWorthAdding of what was taken out of it since it was fitted. A bias step comes first:
/// what lies beside it is judged once it is masked. What describes and is not named also has to
/// hold on each of several runs when that is left out. Where nothing else holds, a network on the
/// temperature and its rate is tried, unless the model has one or there is but one run. Nothing is
/// tried where nothing is missing, or where what is left is no function of the signals: a cycle, a
/// random walk. `data` has the rows of `runs.training`.
NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, const JudgingRuns& runs,
                        const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
