#pragma once

#include "model/model.hpp"
#include "support/json.hpp"

namespace fogcomp::workbench {

/// The terms of a model for people: coefficients and shape parameters with their uncertainties in
/// their own units, and where a shape may be looked for.
Json terms_json(const model::Model& model);

/// The model itself ("text", its file), its terms and its history.
Json model_json(const model::Model& model);

}  // namespace fogcomp::workbench
