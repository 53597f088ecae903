#pragma once

#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// Findings of `fogcomp compare`, with plots. The best model, with the smallest rms on its worst
/// run, comes first, and is on top in plots of several; plots for a single model show the best one.
Document compare_findings(const std::vector<compare::ModelOnRuns>& models);

}  // namespace fogcomp::findings
