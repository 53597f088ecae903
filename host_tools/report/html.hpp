#pragma once

#include <string>
#include <utility>
#include <vector>

#include "findings/text.hpp"
#include "report/report.hpp"
#include "support/embedded_file.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// A text, escaped for the content of an element or for a quoted attribute; UTF-8 is made valid.
std::string escaped(std::string text);
std::string escaped(const findings::Text& text);

/// JSON as the content of a <script> element, without "<", so that it cannot end the element.
std::string script_data(const Json& json);

/// The text of the embedded file `name`. Throws std::logic_error if it is not among `files`.
const std::string& file_of(const std::vector<EmbeddedFile>& files, const std::string& name);

/// `frame` with each {{name}} replaced by the part of that name. Throws std::logic_error if a part
/// is missing.
std::string filled(const std::string& frame,
                   const std::vector<std::pair<std::string, std::string>>& parts);

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
