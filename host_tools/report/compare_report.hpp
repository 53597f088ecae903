#pragma once

#include <vector>

#include "compare/model_on_runs.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// What `fogcomp compare` finds, with plots. The best model, which leaves the smallest rms on its
/// worst run, comes first, and lies on top in plots of several; what only one model can have is of
/// that one.
Report compare_report(const std::vector<ModelOnRuns>& models);

}  // namespace fogcomp::report
