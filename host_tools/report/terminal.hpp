#pragma once

#include <string>

#include "findings/document.hpp"

namespace fogcomp::report {

/// The findings as lines of text without plots: the main finding, then what to do next
/// ("next: COMMAND"), then sentences and tables. `details`: also the figures that a page draws.
std::string terminal(const findings::Document& document, bool details = false);

}  // namespace fogcomp::report
