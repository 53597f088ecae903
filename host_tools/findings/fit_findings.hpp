#pragma once

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::findings {

/// What `fogcomp fit` found. `model`: FitOutcome::on_its_runs() of it.
Document fit_findings(const workflow::FitOutcome& fit, const compare::ModelOnRuns& model);

}  // namespace fogcomp::findings
