#pragma once

#include <string>

#include "compare/run_summary.hpp"
#include "recording/recording.hpp"

namespace fogcomp::cli {

/// The summary as tables for a terminal, about 90 columns wide.
std::string info_text(const Recording& recording, const RunSummary& summary);

}  // namespace fogcomp::cli
