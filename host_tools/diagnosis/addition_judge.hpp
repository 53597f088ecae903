#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fit/add_effect.hpp"
#include "runs/runs.hpp"

namespace fogcomp::diagnosis {

/// Argument of `add`: effects, an expression, or cuts of the runs.
struct AdditionRequest {
  std::vector<std::string> effects;  ///< as fit::change_effects() takes them; or else
  std::string expression;            ///< `NAME = EXPRESSION`; or else cuts
  bool run_offsets = false;          ///< with a bias of its own for each power-on
  bool refines = false;  ///< frees what the formulas of the model's own effects leave out
  std::vector<recording::Cut> cuts{};  ///< for bias steps

  std::vector<std::string> names() const;  ///< without their parameters
  bool is_network() const;
};

/// Name of what a cut makes up for.
constexpr const char* kBiasStep = "bias_step";

/// A tested addition, judged as `add` judges it.
struct TriedAddition {
  AdditionRequest request;
  bool accepted = false;
  std::string reason;        ///< one line: why it is accepted or not
  std::string needless{};    ///< as fit::AdditionVerdict has it
  double rms_after_dph = 0;  ///< out of sample; both 0 if it could not be judged
  double rms_before_dph = 0;
  double fitted_before_dph = 0;  ///< as fit::AdditionVerdict has them
  double fitted_after_dph = 0;
  std::optional<model::HistoryEntry::Holdout> holdouts{};
  /// The resulting model, without a network; only if accepted.
  std::optional<model::Model> model;

  judge::Score score;  ///< out of sample
  /// Whether it gains clearly more than another addition to the same model.
  bool is_clearly_better(const TriedAddition& other) const {
    return score.gain >= other.score.gain + judge::kGain;
  }
};

/// Runs the command `add`, network included, and returns verdict and model. Throws InputError like
/// fit::add_effect().
fit::Addition try_to_add(const model::Model& model, const AdditionRequest& request,
                         const runs::Runs& runs);

/// Tries additions as `add` would judge them, without the model's network. The model is refitted
/// once for all of them, and the regressors of the runs are remembered from model to model.
class AdditionJudge {
 public:
  /// `runs` must outlive the judge. `run_offsets`: with a bias of its own for each power-on.
  AdditionJudge(const model::Model& model, const runs::Runs& runs, bool run_offsets);

  const runs::Runs& runs() const { return *runs_; }
  series::BiasOf bias_of() const { return bias_of_; }
  /// What has one bias in the next trials: each power-on, or all recordings. With `all`, other
  /// recordings than those fitted must judge: rows left out of one say nothing of the others.
  void share_bias(series::BiasOf of);

  /// The next trials are on these runs, of the same rows.
  void go_on_with(runs::Runs runs);
  /// The next trials start from this model, which has the same rows and derivative.
  void go_on_from(const model::Model& model);

  /// Refits the model without a change, if that has not been done; before calls from several
  /// threads.
  void prepare() const;

  TriedAddition operator()(AdditionRequest request) const;

  /// Whether a change of shapes would be certainly visible in the runs of the fit
  /// (fit::possible_gain(), kCertainSigmas). A trial takes a hundred times as long.
  bool may_help(const AdditionRequest& request) const;

 private:
  void forget();  // the refit, which is of another model, other biases or other runs
  bool has_own_biases() const { return bias_of_ == series::BiasOf::power_on; }
  // The trial with the verdict, without a model.
  TriedAddition verdict_of(const fit::Addition& addition, TriedAddition trial) const;
  std::string objection_of_biases(const fit::Addition& addition) const;

  model::Model model_;
  std::optional<runs::Runs> cut_runs_;
  const runs::Runs* runs_;
  series::BiasOf bias_of_;
  // Made by prepare(), once they are needed.
  mutable std::shared_ptr<const fit::KnownRegressors> series_;  // of the runs
  mutable std::optional<fit::RefittedModel> refitted_;
  mutable std::string failure_;  // why there is none
};

}  // namespace fogcomp::diagnosis
