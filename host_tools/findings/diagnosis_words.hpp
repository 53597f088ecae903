#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "diagnosis/next_step.hpp"
#include "findings/next_step_words.hpp"

namespace fogcomp::findings {

/// What a diagnosis found, for people, without figures that belong in tables.
struct DiagnosisWords {
  std::string verdict;                ///< the finding itself
  std::string certainty;              ///< of the verdict, or between which effects; may be ""
  std::vector<std::string> findings;  ///< how much it is, where it sits, which test would tell
  std::string next;                   ///< what to do, where no command does it; may be ""
  std::string command;                ///< or the command line that does it; may be ""
  std::vector<std::string> limits;    ///< what limits the answer
};

DiagnosisWords words_of(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                        const DiagnosedFiles& files);

/// A diagnosis in one line, and the figures in it.
struct BriefDiagnosis {
  std::vector<std::string> effects;  ///< missing: all of them together, or one of them
  double size_dph = 0;               ///< of these, or of all that is above the noise, rms
  std::optional<double> probability;
  std::string sentence;
};
BriefDiagnosis in_brief(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next);

/// Why the loop came to its end.
std::string end_words(const diagnosis::Ladder& ladder);

/// The shape of an effect: "radius 5.2 degC".
std::string shape_words(const model::EffectTerm& term);

}  // namespace fogcomp::findings
