#pragma once

#include <string>

#include "findings/document.hpp"

namespace fogcomp::report {

/// What was found as lines for a terminal, plots left out: first what was found, then what to do
/// ("next: COMMAND"), then sentences and tables. `details`: also what a page draws, as figures.
std::string terminal(const findings::Document& document, bool details = false);

}  // namespace fogcomp::report
