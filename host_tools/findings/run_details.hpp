#pragma once

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// What a page draws of a run, as figures for a terminal: dependences, loop, Allan deviation,
/// autocorrelation.
void add_details(Document& document, const compare::ModelOnRun& judged);

}  // namespace fogcomp::findings
