#include "findings/visible_table.hpp"

#include <cmath>

#include "findings/figures.hpp"

namespace fogcomp::findings {

Table visible_table(const std::vector<planning::VisibleSize>& sizes, const std::string& measured) {
  Table table;
  table.columns = {"effect", "typical", "visible from"};
  table.notes = words("deg/h rms over " + measured +
                      "; typical: in the size of the catalogue's example; visible from: the size "
                      "that differs by three standard deviations from all that the other effects "
                      "do");
  for (const planning::VisibleSize& size : sizes) {
    table.rows.push_back(
        {verbatim(size.effect), significant(size.typical_dph), visible_text(size.visible_dph)});
  }
  return table;
}

Text visible_text(double visible_dph) {
  return std::isfinite(visible_dph) ? significant(visible_dph) : Text("never");
}

}  // namespace fogcomp::findings
