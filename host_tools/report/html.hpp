#pragma once

#include <string>

#include "findings/text.hpp"
#include "report/report.hpp"
#include "support/embedded_file.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// A text, escaped for the content of an element or for a quoted attribute; UTF-8 is made valid.
std::string escaped(std::string text);
std::string escaped(const findings::Text& text);

/// Contents of a page; all pages have the same frame (page/frame.html).
struct PageContent {
  std::string subject;                    ///< title of the page: the command line
  std::string report{};                   ///< the findings as HTML; "": none
  Json plots = Json::array();             ///< data of the report's plots (plots.hpp)
  bool draws = false;                     ///< whether the report has plots
  const WorkbenchSetup* bench = nullptr;  ///< nullptr: the page has no workbench
};

/// The whole page as HTML.
std::string framed(const PageContent& content);

}  // namespace fogcomp::report
