#pragma once

#include <string>

#include "compare/model_on_runs.hpp"

namespace fogcomp::cli {

/// Everything known of one model on one run, as tables for a terminal.
std::string run_details(const ModelOnRun& run);

}  // namespace fogcomp::cli
