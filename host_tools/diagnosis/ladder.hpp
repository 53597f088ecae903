#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/next_step.hpp"

namespace fogcomp::diagnosis {

/// The whole loop: diagnose, add what is proposed, refit everything, look again.
struct Ladder {
  struct Step {
    TriedAddition addition;
    bool describes = false;  ///< as NextStep has it
    /// Effects that these recordings cannot tell from what was added.
    std::vector<std::string> alternatives;
    double rms_before_dph = 0;  ///< as the diagnoses before and after the step have it
    double rms_after_dph = 0;
  };
  Diagnosis first;     ///< of the model as it came
  NextStep next;       ///< after it
  Diagnosis last;      ///< of the model at the end of the loop
  NextStep last_next;  ///< after it; empty where the loop may add no more
  std::vector<Step> steps;
  /// What held out of sample, but left more in the rows of the diagnosis than was there before; ""
  /// where that did not end the loop.
  std::string left_alone;
  model::Model model;  ///< at the end, as the commands `add` of the steps make it

  /// Names of what the loop added, in that order, each once: what it named as missing, and what
  /// only describes.
  std::vector<std::string> added() const { return names(false); }
  std::vector<std::string> described() const { return names(true); }

 private:
  std::vector<std::string> names(bool described) const;
};

/// Adds what find_next_step() proposes, up to `max_steps` times, each step made and judged as `add`
/// does it on `runs`. Ends where it proposes nothing more. Throws InputError as add() does.
Ladder stepwise_selection(const model::Model& model, const DiagnosisData& data,
                          const JudgingRuns& runs, int max_steps,
                          const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
