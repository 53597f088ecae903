#pragma once

#include <string>
#include <vector>

#include "model/catalogue.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {

/// Columns of a recording that an effect needs beside the three required ones.
std::vector<std::string> needed_columns(const model::CatalogueEntry& entry);

/// All data of an entry, for scripts.
Json effect_json(const model::CatalogueEntry& entry);

/// The catalogue for a terminal, one effect in full and several in a line each; and as the document
/// host_tools/EFFECTS.md.
std::string effects_text(const std::vector<const model::CatalogueEntry*>& entries);
std::string effects_markdown(const std::vector<const model::CatalogueEntry*>& entries);

}  // namespace fogcomp::cli
