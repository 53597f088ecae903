#pragma once

#include <string>

#include "findings/document.hpp"
#include "report/workbench_page.hpp"

namespace fogcomp::report {

/// One HTML page that needs nothing else: words and tables as HTML, plots as data with the script
/// that draws them. Nothing that is given becomes markup. `bench`: what the workbench of the page
/// begins with; nullptr: it has none.
std::string page(const findings::Document& document, const WorkbenchSetup* bench = nullptr);

}  // namespace fogcomp::report
