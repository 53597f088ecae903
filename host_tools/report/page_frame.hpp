#pragma once

#include <string>

#include "report/workbench_page.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// What goes into the frame that all pages have (page/frame.html).
struct PageContent {
  std::string subject;
  std::string report{};                   ///< what was found, as HTML; "": nothing
  Json plots = Json::array();             ///< of the report
  bool draws = false;                     ///< whether it has some
  const WorkbenchSetup* bench = nullptr;  ///< nullptr: the page does not calculate
};

std::string framed(const PageContent& content);

}  // namespace fogcomp::report
