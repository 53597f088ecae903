#pragma once

#include "compare/run_summary.hpp"
#include "findings/document.hpp"
#include "planning/information.hpp"
#include "recording/recording.hpp"

namespace fogcomp::findings {

/// Output of `fogcomp info`, with plots. `summary` is that of `recording`, `visible` what it can
/// show.
Document info_findings(const recording::Recording& recording, const compare::RunSummary& summary,
                       const std::vector<planning::VisibleSize>& visible = {});

}  // namespace fogcomp::findings
