#pragma once

#include <vector>

#include "compare/model_on_runs.hpp"
#include "compare/run_in_blocks.hpp"
#include "model/model.hpp"

namespace fogcomp::fit {

/// By how much the bias of every further run lies above that of the first, deg/h, in the order of
/// the runs. The model's terms are fitted to all runs anew, each with a constant of its own, so
/// that what goes with temperature, time or any other input is the terms' part and not the
/// constant's; shapes stay as they are, and a network's part is taken out before. The uncertainty
/// is that of a fit's coefficients (coefficient_covariance.hpp), which knows slow noise and what a
/// model may lack, and what no formula of a drift is exact to (rules::kModelFormTolerance). Empty
/// for one run, and where the runs do not tell a constant from the terms (a run at one temperature
/// each).
std::vector<compare::TurnOnBias> turn_on_biases(const model::Model& model,
                                                const std::vector<compare::RunInBlocks>& runs);

}  // namespace fogcomp::fit
