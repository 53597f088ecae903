#pragma once

#include <string>

#include "findings/document.hpp"
#include "model/model.hpp"

namespace fogcomp::findings {

/// What each step of a model left on the data of its last fit. The model has a history.
Table error_ladder(const model::Model& model);

/// What was done to make a model, and what it has become: steps, errors, coefficients.
Document history_findings(const model::Model& model, const std::string& file);

}  // namespace fogcomp::findings
