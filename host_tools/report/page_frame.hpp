#pragma once

#include <string>

#include "report/workbench_page.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// Contents of a page; all pages have the same frame (page/frame.html).
struct PageContent {
  std::string subject;                    ///< title of the page: the command line
  std::string report{};                   ///< the findings as HTML; "": none
  Json plots = Json::array();             ///< data of the report's plots (plot_json.hpp)
  bool draws = false;                     ///< whether the report has plots
  const WorkbenchSetup* bench = nullptr;  ///< nullptr: the page has no workbench
};

/// The whole page as HTML.
std::string framed(const PageContent& content);

}  // namespace fogcomp::report
