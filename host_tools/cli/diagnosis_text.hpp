#pragma once

#include <string>

#include "diagnosis/ladder.hpp"

namespace fogcomp::cli {

/// What was found, in words that an engineer reads in ten seconds, then the details. `model` and
/// `runs` as on the command line, for the command that comes next.
std::string diagnosis_text(const Diagnosis& diagnosis, const std::string& model,
                           const std::string& runs);

/// Step by step: what was added, what it brought, what is left.
std::string ladder_text(const Ladder& ladder);

}  // namespace fogcomp::cli
