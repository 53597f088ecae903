#pragma once

#include <string>

#include "findings/document.hpp"
#include "model/model.hpp"

namespace fogcomp::findings {

/// Whether a board with the default settings can run the model, with the extension if it needs it.
bool can_be_exported(const model::Model& model, const std::string& file);

/// Proposes the `export` that a board's header needs, with `why`; if no board with the default
/// settings can run the model, says what stands against it.
void next_export(Document& document, Text why, const model::Model& model, const std::string& file);

}  // namespace fogcomp::findings
