#pragma once

#include <string>

#include "findings/document.hpp"
#include "model/model.hpp"

namespace fogcomp::findings {

/// Proposes the `export` that a board's header needs, with `why`; if no board with the default
/// settings can run the model, says what stands against it.
void next_export(Document& document, Text why, const model::Model& model, const std::string& file);

}  // namespace fogcomp::findings
