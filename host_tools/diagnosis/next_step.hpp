#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/addition_judge.hpp"
#include "diagnosis/descriptions.hpp"
#include "diagnosis/diagnosis.hpp"

namespace fogcomp::diagnosis {

/// Action proposed after a diagnosis.
struct NextStep {
  /// The accepted addition: what the diagnosis names, else the best description.
  std::optional<TriedAddition> addition;
  /// Names, if the catalogue explains the residual and only these together are accepted.
  std::vector<std::string> together;
  bool describes = false;  ///< the addition lowers the error, and says nothing of the cause
  /// It holds with a bias of its own for each power-on: with one for all nothing does, or the
  /// biases differ beside it.
  bool only_with_own_biases = false;
  /// It shows with one bias for all recordings; within them nothing is missing.
  bool only_between_recordings = false;
  bool refutes_name = false;  ///< what the diagnosis names is refused, and so are its rivals
  std::vector<TriedAddition> refused;
  std::vector<Form> forms;               ///< best first
  std::optional<Experiment> experiment;  ///< that would tell these apart
  /// Chance that noise alone would look like these forms, where only they show that something is
  /// missing.
  std::optional<double> chance_of_forms;
};

/// What frees something that the formulas of the model's own effects leave out, if it is accepted.
NextStep find_refinement(const model::Model& model, const AdditionJudge& judge);

/// Tries what `diagnosis` names; if that is refused, its rivals, most probable first. If
/// none holds, or it names nothing: a certain jump, beside which the rest is judged, or else a
/// certain part of what is missing and formulas over the signals that vary (formulas_over()), of
/// which the one that gains most is taken. If all fail, or a formula is left, a refinement is tried
/// (find_refinement()), then a network of temperature and rate, unless the model has one or there
/// is only one run. No formula is tried if most of the residual is no function of the signals (a
/// cycle, jumps). Where what is left may be a random walk, formulas alone are asked. `data` has the
/// rows of the training runs of `judge`, which is of `model`.
NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, const AdditionJudge& judge,
                        const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
