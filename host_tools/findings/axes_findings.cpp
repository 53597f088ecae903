#include "findings/findings.hpp"

#include <utility>

#include "support/text.hpp"

namespace fogcomp::findings {

Document axes_table(const std::string& subject, const std::vector<AxisFindings>& axes) {
  Document document(subject, words(format("%zu axes", axes.size())));
  Table table;
  table.columns = {"axis", "found"};
  for (const AxisFindings& each : axes) {
    table.rows.push_back({verbatim(each.axis), each.document.found()});
  }
  document.table(std::move(table));
  return document;
}

Document axes_findings(const std::string& subject, const std::vector<AxisFindings>& axes) {
  Document document = axes_table(subject, axes);
  for (const AxisFindings& each : axes) {
    document.heading(verbatim(each.axis));
    document.append(each.document);
  }
  return document;
}

}  // namespace fogcomp::findings
