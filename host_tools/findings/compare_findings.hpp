#pragma once

#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// What `fogcomp compare` finds, with plots. The best model, which leaves the smallest rms on its
/// worst run, comes first, and lies on top in plots of several; what only one model can have is of
/// that one.
Document compare_findings(const std::vector<compare::ModelOnRuns>& models);

}  // namespace fogcomp::findings
