#pragma once

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::findings {

/// Findings of `fogcomp fit`. `model`: its FitOutcome::on_its_runs().
Document fit_findings(const workflow::FitOutcome& fit, const compare::ModelOnRuns& model);

/// One sentence for each bias but the first, where power-ons and parts of cut runs have their own.
std::vector<Text> own_bias_words(const fit::Identification& identified);

}  // namespace fogcomp::findings
