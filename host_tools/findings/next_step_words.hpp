#pragma once

#include <string>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "diagnosis/next_step.hpp"
#include "findings/document.hpp"
#include "model/model.hpp"

namespace fogcomp::findings {

/// Input and output files of a diagnosis, as on the command line.
struct DiagnosedFiles {
  std::string model;
  std::vector<std::string> runs;
  std::vector<std::string> holdouts{};
  std::vector<std::string> reading{};  ///< options for reading the recordings
  std::string output{};                ///< model at the end of the selection; "": not written
  std::vector<std::string> options{};  ///< of the diagnosis itself, for another one like it
};

/// The options that make these cuts.
std::vector<std::string> cut_words(const std::vector<recording::Cut>& cuts);

/// The command line for the requested addition to `model`.
std::string add_command_line(const diagnosis::AdditionRequest& request, const std::string& model,
                             const DiagnosedFiles& files);

/// Sentences about an addition that lowers the error without explaining the cause.
std::vector<std::string> description_words(const diagnosis::NextStep& next);

/// "aging was tried and refused, does not help out of sample: ...".
std::string refusal_words(const diagnosis::TriedAddition& refused);

/// Why nothing is proposed; "" if nothing was tried. The first trial was the named effect or the
/// best description.
std::string nothing_holds_words(const diagnosis::NextStep& next);

/// A step of the selection: "+ temperature_rate (or shupe)".
std::string step_words(const diagnosis::Ladder::Step& step);

/// The command lines that reproduce the final model step by step, byte for byte.
std::vector<std::string> ladder_commands(const diagnosis::Ladder& ladder,
                                         const DiagnosedFiles& files);

/// The `export` that a board's header needs, with `why`; if no board with the default settings can
/// run the model, what stands against it.
Next next_export(Text why, const model::Model& model, const std::string& file);

}  // namespace fogcomp::findings
