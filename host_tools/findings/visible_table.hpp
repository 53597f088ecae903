#pragma once

#include <string>
#include <vector>

#include "findings/document.hpp"
#include "planning/information.hpp"

namespace fogcomp::findings {

/// The size from which on each effect is visible, beside its typical size. `measured`: the rows
/// over which sizes are an rms.
Table visible_table(const std::vector<planning::VisibleSize>& sizes, const std::string& measured);

/// deg/h; "never" if it is not finite.
Text visible_text(double visible_dph);

}  // namespace fogcomp::findings
