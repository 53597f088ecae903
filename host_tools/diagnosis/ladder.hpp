#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/next_step.hpp"

namespace fogcomp::diagnosis {

/// Result of a stepwise selection: diagnose, add the proposal, refit everything, repeat.
struct Ladder {
  struct Step {
    /// Its errors are of the rows of the diagnosis, without the model's network unless that is
    /// added.
    TriedAddition addition;
    bool describes = false;  ///< as NextStep has it
    /// Effects that these recordings cannot distinguish from the added one.
    std::vector<std::string> alternatives;
  };
  Diagnosis first;     ///< of the model as it came
  NextStep next;       ///< after it
  Diagnosis last;      ///< of the model at the end of the loop
  NextStep last_next;  ///< after it; empty where the loop may add no more
  std::vector<Step> steps;
  /// Of holdouts whose bias jumps: additions are judged with them. Found where one was refused.
  std::vector<recording::Cut> holdout_cuts;
  bool is_cut_off = false;  ///< no more may be added: last_next was not looked for
  model::Model model;       ///< at the end, as the commands `add` of the steps make it

  /// Cuts of the holdouts, then those that were added.
  std::vector<recording::Cut> cuts() const;
  /// Names of the additions in their order, each once: added() were named as missing, described()
  /// only describe the residual.
  std::vector<std::string> added() const { return names(false); }
  std::vector<std::string> described() const { return names(true); }

 private:
  std::vector<std::string> names(bool described) const;
};

/// Adds the proposals of find_next_step(), up to `max_steps` and refinements, which add no effect;
/// each step is made and judged by `add` on `runs`. Ends when nothing is proposed. Where something
/// is refused, holdouts are looked at themselves: on one whose bias jumps nothing holds. Throws
/// InputError like add().
Ladder stepwise_selection(const model::Model& model, const DiagnosisData& data,
                          const runs::Runs& runs, int max_steps,
                          const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
