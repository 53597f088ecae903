#pragma once

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// The plots of a run as values for a terminal: dependences, loop, Allan deviation,
/// autocorrelation.
void add_details(Document& document, const compare::ModelOnRun& judged);

}  // namespace fogcomp::findings
