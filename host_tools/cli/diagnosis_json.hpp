#pragma once

#include "diagnosis/ladder.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {

/// What `diagnose --json` prints; host_tools/README.md lists the keys.
Json diagnosis_json(const Diagnosis& diagnosis);

/// The same of the first diagnosis of a loop, with the ladder and what is left at its end.
Json ladder_json(const Ladder& ladder);

}  // namespace fogcomp::cli
