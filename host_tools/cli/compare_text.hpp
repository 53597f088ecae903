#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"

namespace fogcomp::cli {

/// A line for each run and model, what is still in the residual, warnings; then the segments.
/// Several models stand side by side. `details` adds effects, dependences, Allan deviation and
/// autocorrelation of each.
std::string compare_text(const std::vector<ModelOnRuns>& models, bool details);

}  // namespace fogcomp::cli
