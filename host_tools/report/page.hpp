#pragma once

#include <string>

#include "findings/document.hpp"

namespace fogcomp::report {

/// One HTML page that needs nothing else: words and tables as HTML, plots as data with the script
/// that draws them. Nothing that is given becomes markup.
std::string page(const findings::Document& document);

}  // namespace fogcomp::report
