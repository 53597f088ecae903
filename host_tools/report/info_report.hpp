#pragma once

#include "compare/run_summary.hpp"
#include "recording/recording.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// What `fogcomp info` prints, with plots. `recording` is what `summary` was made of.
Report info_report(const Recording& recording, const RunSummary& summary);

}  // namespace fogcomp::report
