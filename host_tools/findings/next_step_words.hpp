#pragma once

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

/// The command line that adds to `model` what is asked for.
std::string add_command_line(const diagnosis::AdditionRequest& request, const std::string& model,
                             const DiagnosedFiles& files);

/// Of what lowers the error and is not the cause, as far as anyone knows.
std::vector<std::string> description_words(const diagnosis::NextStep& next);

/// Why nothing is proposed; "" where nothing was tried. The first was named, or describes most.
std::string nothing_holds_words(const diagnosis::NextStep& next);

/// A step of the loop: "+ temperature_rate (or shupe)".
std::string step_words(const diagnosis::Ladder::Step& step);

/// The command lines that make the model at its end step by step, the same to the byte.
std::vector<std::string> ladder_commands(const diagnosis::Ladder& ladder,
                                         const DiagnosedFiles& files);

}  // namespace fogcomp::findings
