#pragma once

#include <string>

#include "compare/model_on_runs.hpp"
#include "fit/fit_model.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// What `fogcomp fit` found, with plots. `model`: on the recordings that it was fitted to, as the
/// board has it; its file is the one that was written. `identification`: what the command prints of
/// it.
Report fit_report(const ModelOnRuns& model, const FitResult& result,
                  const std::string& identification);

}  // namespace fogcomp::report
