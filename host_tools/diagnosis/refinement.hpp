#pragma once

#include <optional>

#include "diagnosis/addition_judge.hpp"
#include "model/model.hpp"

namespace fogcomp::diagnosis {

/// Of what frees something that the formulas of the model's own effects leave out, or keep at a
/// value (model::possible_refinements()), the accepted one that leaves least out of sample. Nothing
/// if none is accepted.
std::optional<TriedAddition> best_refinement(const model::Model& model, AdditionJudge& judge);

}  // namespace fogcomp::diagnosis
