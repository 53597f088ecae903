#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "diagnosis/next_step.hpp"

namespace fogcomp::findings {

/// What a diagnosis read and wrote, as on the command line.
struct DiagnosedFiles {
  std::string model;
  std::vector<std::string> runs;
  std::vector<std::string> holdouts{};
  std::vector<std::string> reading{};  ///< options with which the recordings are read
  std::string output{};                ///< the model at the end of the loop; "": none was written
};

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

/// A step of the loop: "+ temperature_rate (or shupe)".
std::string step_words(const diagnosis::Ladder::Step& step);
/// The command lines that make the model at its end step by step, the same to the byte.
std::vector<std::string> ladder_commands(const diagnosis::Ladder& ladder,
                                         const DiagnosedFiles& files);
/// Why the loop came to its end.
std::string end_words(const diagnosis::Ladder& ladder);

/// The shape of an effect: "radius 5.2 degC".
std::string shape_words(const model::EffectTerm& term);

}  // namespace fogcomp::findings
