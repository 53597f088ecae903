#pragma once

#include <vector>

#include "compare/model_on_runs.hpp"
#include "model/model.hpp"
#include "runs/run.hpp"

namespace fogcomp::fit {

/// Bias of every further power-on less that of the first, in the order of the runs, and how far all
/// of them spread. The model's terms are fitted to all runs again, each power-on with its own
/// constant, so that everything that depends on temperature, time or another input belongs to the
/// terms; shapes are fixed, and a network's drift is subtracted before. The uncertainty is that of
/// a fit's coefficients (predict.hpp), which includes slow noise and missing
/// effects, and the error of the formulas (rules::kModelFormTolerance); a bias is certain if it is
/// so beside any smooth drift with temperature, too. No single biases for one power-on, and if the
/// runs do not separate a constant from the terms (a temperature that never varies in any).
compare::TurnOn turn_on_biases(const model::Model& model, const std::vector<runs::Run>& runs);

}  // namespace fogcomp::fit
