#pragma once

#include <string>

#include "findings/document.hpp"
#include "report/workbench_page.hpp"

namespace fogcomp::report {

/// A self-contained HTML page: words and tables as HTML, plots as data with the script that draws
/// them. All text is escaped. `bench`: initial state of the page's workbench; nullptr: no
/// workbench.
std::string page(const findings::Document& document, const WorkbenchSetup* bench = nullptr);

}  // namespace fogcomp::report
