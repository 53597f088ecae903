#include "report/workbench_page.hpp"

#include "report/embedded_engine.hpp"
#include "report/embedded_page.hpp"
#include "report/page_frame.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::report {

std::string why_no_workbench() {
  if (embedded_engine().module.empty()) {
    return "this fogcomp was built without its engine for pages: host_tools/quickstart.sh --page "
           "builds it";
  }
  if (plot_library_files().empty()) {
    return "this fogcomp was built without its plot library: install npm and build it again";
  }
  return "";
}

std::string workbench_page(const WorkbenchSetup& setup) {
  const std::string missing = why_no_workbench();
  if (!missing.empty()) throw InputError("workbench", missing);
  std::vector<std::string> words{"fogcomp workbench"};
  for (const WorkbenchSetup::State& state : setup.states) words.push_back(state.model);
  words.insert(words.end(), setup.runs.begin(), setup.runs.end());
  PageContent content{join(words, " ")};
  content.bench = &setup;
  return framed(content);
}

}  // namespace fogcomp::report
