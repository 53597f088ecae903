#pragma once

#include <string>
#include <vector>

#include "findings/document.hpp"
#include "fit/add_effect.hpp"

namespace fogcomp::findings {

/// Findings of `fogcomp add`, with plots of every run before and after. `model`: the original
/// model; `written`: the new file, "" if none was written.
Document add_findings(const fit::Addition& addition, const std::string& model,
                      const std::string& written);

}  // namespace fogcomp::findings
