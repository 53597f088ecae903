#include "findings/findings.hpp"

#include "support/text.hpp"

namespace fogcomp::findings {

Document axes_table(const std::string& subject, const std::vector<AxisFindings>& axes) {
  Table table;
  table.columns = {"axis", "found"};
  for (const AxisFindings& each : axes) {
    table.rows.push_back({verbatim(each.axis), each.document.found});
  }
  return {subject, words(format("%zu axes", axes.size())), {}, {}, table};
}

Document axes_findings(const std::string& subject, const std::vector<AxisFindings>& axes) {
  Document document = axes_table(subject, axes);
  for (const AxisFindings& each : axes) {
    document.parts += Heading{verbatim(each.axis)} + each.document.as_parts();
  }
  return document;
}

}  // namespace fogcomp::findings
