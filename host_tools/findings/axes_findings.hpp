#pragma once

#include <string>
#include <vector>

#include "findings/document.hpp"

namespace fogcomp::findings {

/// What a command found of one axis.
struct AxisFindings {
  std::string axis;
  Document document;
};

/// The axes of one call side by side: a table of what was found of each.
Document axes_table(const std::string& subject, const std::vector<AxisFindings>& axes);

/// That, and then all that was found of each axis.
Document axes_findings(const std::string& subject, const std::vector<AxisFindings>& axes);

}  // namespace fogcomp::findings
