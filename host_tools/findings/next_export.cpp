#include "findings/next_export.hpp"

#include <utility>
#include <vector>

#include "workflow/export_header.hpp"

namespace fogcomp::findings {

bool can_be_exported(const model::Model& model, const std::string& file) {
  return workflow::export_refusal(model, file, true).empty();
}

Next next_export(Text why, const model::Model& model, const std::string& file) {
  std::vector<std::string> command{"fogcomp", "export", file, "-o", "fog_model.h"};
  std::string refusal = workflow::export_refusal(model, file, false);
  if (!refusal.empty() && can_be_exported(model, file)) {
    command.emplace_back("--extension");
    refusal.clear();
  }
  if (refusal.empty()) return {std::move(why), command};
  return words("nothing to add; for a board it is not ready: " + refusal, {file});
}

}  // namespace fogcomp::findings
