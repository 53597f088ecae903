#pragma once

#include <string>

#include "findings/document.hpp"
#include "fit/add_effect.hpp"

namespace fogcomp::findings {

/// What `fogcomp add` found, with plots of every run before and after. `model`: the one that the
/// effect was to be added to; `written`: the file with it, "" where nothing was written.
Document add_findings(const fit::Addition& addition, const std::string& model,
                      const std::string& written);

}  // namespace fogcomp::findings
