#pragma once

#include <string>

#include "findings/document.hpp"
#include "model/model.hpp"

namespace fogcomp::findings {

/// Whether a board with the default settings can run the model, with the extension if it needs it.
bool can_be_exported(const model::Model& model, const std::string& file);

/// The `export` that a board's header needs, with `why`; if no board with the default settings can
/// run the model, what stands against it.
Next next_export(Text why, const model::Model& model, const std::string& file);

}  // namespace fogcomp::findings
