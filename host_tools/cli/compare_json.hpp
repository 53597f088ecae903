#pragma once

#include <vector>

#include "compare/model_on_runs.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {

/// The contract's object for the first model, with everything else that is known of each run; and
/// the same for every model under `models`. host_tools/README.md lists the keys.
Json compare_json(const std::vector<ModelOnRuns>& models);

}  // namespace fogcomp::cli
