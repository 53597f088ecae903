#pragma once

#include "compare/run_summary.hpp"
#include "findings/document.hpp"
#include "recording/recording.hpp"

namespace fogcomp::findings {

/// Output of `fogcomp info`, with plots. `summary` is that of `recording`.
Document info_findings(const recording::Recording& recording, const compare::RunSummary& summary);

}  // namespace fogcomp::findings
