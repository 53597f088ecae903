#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "diagnosis/next_step.hpp"
#include "findings/next_step_words.hpp"

namespace fogcomp::findings {

/// A diagnosis in words, without the values of tables.
struct DiagnosisWords {
  std::string verdict;                ///< the result
  std::string certainty;              ///< probabilities of it and of the alternatives
  std::string size;                   ///< of what is left
  std::string place;                  ///< where it is; may be ""
  std::string next;                   ///< advice without a command; may be ""
  std::string command;                ///< command line to type next; may be ""
  std::vector<std::string> findings;  ///< more, and the experiment that would decide
  std::vector<std::string> limits;    ///< reservations
};

DiagnosisWords words_of(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                        const DiagnosedFiles& files);

/// A diagnosis in one line, with its values.
struct BriefDiagnosis {
  std::vector<std::string> effects;  ///< missing: all together, or one of them
  double size_dph = 0;               ///< rms of these, or of everything above the noise
  std::optional<double> probability;
  std::string sentence;
};
BriefDiagnosis in_brief(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next);

/// How long after power-on a board has no valid rate, because of the lags of the model at the end
/// of the loop or, where none was made, with what is proposed; "" if no lag costs time.
std::string settling_words(const diagnosis::Ladder& ladder);

/// Why the stepwise selection ended.
std::string end_words(const diagnosis::Ladder& ladder);

/// The shape parameters of an effect: "radius 5.2 degC".
std::string shape_words(const model::EffectTerm& term);

// Sentences about the residual of a model; "" if there is nothing to say.

/// What the model leaves, as `compare` says; the noise; what is left with what `next` adds.
std::string size_words(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next);
/// Segments and variables of the residual.
std::string where_words(const diagnosis::Diagnosis& diagnosis);
/// Cycles and jumps, which do not depend on the inputs.
std::string fast_words(const diagnosis::Diagnosis& diagnosis);
/// That nothing is missing, and that something is which is no effect of the catalogue.
std::string probability_words(const diagnosis::Diagnosis& diagnosis);
/// What the network, which the diagnosis excludes, had learnt.
std::string network_words(const diagnosis::Diagnosis& diagnosis);

}  // namespace fogcomp::findings
