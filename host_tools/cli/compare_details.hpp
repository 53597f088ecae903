#pragma once

#include <string>

#include "cli/compare_text.hpp"

namespace fogcomp::cli {

/// Everything known of one model on one run, as tables for a terminal.
std::string run_details(const ModelOnRun& run);

}  // namespace fogcomp::cli
