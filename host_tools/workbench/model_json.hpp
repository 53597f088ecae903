#pragma once

#include "model/model.hpp"
#include "support/json.hpp"

namespace fogcomp::workbench {

/// The terms of a model: coefficients and shape parameters with standard deviations in their
/// natural units, and the bounds of each shape parameter.
Json terms_json(const model::Model& model);

/// A model: its file ("text"), terms, history and options of its rows.
Json model_json(const model::Model& model);

}  // namespace fogcomp::workbench
