#include "findings/next_export.hpp"

#include <utility>
#include <vector>

#include "workflow/export_header.hpp"

namespace fogcomp::findings {

void next_export(Document& document, Text why, const model::Model& model, const std::string& file) {
  std::vector<std::string> command{"fogcomp", "export", file, "-o", "fog_model.h"};
  std::string refusal = workflow::export_refusal(model, file, false);
  if (!refusal.empty() && workflow::export_refusal(model, file, true).empty()) {
    command.emplace_back("--extension");
    refusal.clear();
  }
  if (refusal.empty()) {
    document.next(std::move(why), command);
  } else {
    document.next(words("nothing to add; for a board it is not ready: " + refusal, {file}));
  }
}

}  // namespace fogcomp::findings
