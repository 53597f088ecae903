#pragma once

#include "findings/document.hpp"
#include "findings/json.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::findings {

/// What a fit made of its prior: which coefficients the recordings moved, by how many standard
/// deviations. Nothing without a prior.
void add_prior(Document& document, const workflow::FitOutcome& fit);

/// The same; null without a prior.
Json prior_json(const workflow::FitOutcome& fit);

}  // namespace fogcomp::findings
