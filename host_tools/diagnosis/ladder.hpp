#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"

namespace fogcomp::diagnosis {

/// The whole loop: diagnose, add what is named, refit everything, look again.
struct Ladder {
  struct Step {
    std::string effect;                     ///< added; or taken out again, where `removed`
    bool removed = false;                   ///< superfluous since something else was added
    std::vector<std::string> alternatives;  ///< which these recordings cannot tell from it
    double rms_before_dph = 0;
    double rms_after_dph = 0;
  };
  Diagnosis first;  ///< of the model as it came
  Diagnosis last;   ///< of the model at the end of the loop
  std::vector<Step> steps;
  /// What the last diagnosis would add, but for so little that it may be how inexactly the effects
  /// before describe what they took out; "" if nothing.
  std::string left_alone;
  std::vector<model::EffectTerm> terms;  ///< at the end, with coefficients

  /// Effects that the loop added and kept, in that order.
  std::vector<std::string> added() const;
};

/// Adds up to `most_effects`: what is named, or the likeliest of those that the recordings cannot
/// tell apart. After each, an effect that the loop had added before and that is no longer needed is
/// taken out. Ends where nothing is missing, or what is missing is unknown.
Ladder walk_ladder(const model::Model& model, const DiagnosisData& data, int most_effects,
                   const DiagnosisSettings& settings = {});

}  // namespace fogcomp::diagnosis
