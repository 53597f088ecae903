#pragma once

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::findings {

/// Findings of `fogcomp fit`. `model`: its FitOutcome::on_its_runs().
Document fit_findings(const workflow::FitOutcome& fit, const compare::ModelOnRuns& model);

}  // namespace fogcomp::findings
