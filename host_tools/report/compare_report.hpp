#pragma once

#include <vector>

#include "evaluation/model_on_runs.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// What `fogcomp compare` finds, with plots. The first model is the one that the plots over
/// temperature and the parts are of.
Report compare_report(const std::vector<ModelOnRuns>& models);

}  // namespace fogcomp::report
