#pragma once

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::findings {

/// Findings of `fogcomp fit`. `model`: its FitOutcome::on_its_runs().
Document fit_findings(const workflow::FitOutcome& fit, const compare::ModelOnRuns& model);

/// What a fit that looked for bias steps and found none says of them, else "".
std::string no_step_words(const workflow::FitOutcome& fit);

}  // namespace fogcomp::findings
