#pragma once

#include <string>
#include <vector>

#include "model/catalogue.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {

/// All data of an entry, for scripts.
Json effect_json(const model::CatalogueEntry& entry);

/// The catalogue for a terminal, one effect in full and several in a line each; and as the document
/// host_tools/EFFECTS.md.
std::string effects_text(const std::vector<const model::CatalogueEntry*>& entries);
std::string effects_markdown(const std::vector<const model::CatalogueEntry*>& entries);

}  // namespace fogcomp::cli
