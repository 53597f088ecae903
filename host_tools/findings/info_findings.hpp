#pragma once

#include "compare/run_summary.hpp"
#include "findings/document.hpp"
#include "recording/recording.hpp"

namespace fogcomp::findings {

/// What `fogcomp info` prints, with plots. `recording` is what `summary` was made of.
Document info_findings(const recording::Recording& recording, const compare::RunSummary& summary);

}  // namespace fogcomp::findings
