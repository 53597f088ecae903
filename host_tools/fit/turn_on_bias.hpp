#pragma once

#include <optional>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "compare/run_in_blocks.hpp"
#include "model/model.hpp"

namespace fogcomp::fit {

/// Bias of every further power-on less that of the first, deg/h, in the order of the runs. The
/// model's terms are fitted to all runs again, each power-on with its own constant, so that
/// everything that depends on temperature, time or another input belongs to the terms; shapes are
/// fixed, and a network's drift is subtracted before. The uncertainty is that of a fit's
/// coefficients (coefficient_covariance.hpp), which includes slow noise and missing effects, and
/// the error of the formulas (rules::kModelFormTolerance). Empty for one power-on, and if the runs
/// do not separate a constant from the terms (a run at one temperature each).
std::vector<compare::TurnOnBias> turn_on_biases(const model::Model& model,
                                                const std::vector<compare::RunInBlocks>& runs);

/// The first of them that is certain; nothing if none is.
std::optional<compare::TurnOnBias> certain_turn_on(const model::Model& model,
                                                   const std::vector<compare::RunInBlocks>& runs);

}  // namespace fogcomp::fit
