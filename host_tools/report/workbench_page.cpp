#include "report/workbench_page.hpp"

#include "report/embedded_engine.hpp"
#include "report/embedded_page.hpp"
#include "report/html.hpp"
#include "support/base64.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

std::string file_element(const WorkbenchSetup::File& file) {
  return "<script type=\"text/plain\" data-file=\"" + escaped(file.name) + "\">" +
         base64(file.bytes) + "</script>\n";
}

std::string subject_of(const WorkbenchSetup& setup) {
  std::vector<std::string> words{"fogcomp workbench"};
  if (!setup.model.empty()) words.push_back(setup.model);
  words.insert(words.end(), setup.runs.begin(), setup.runs.end());
  return join(words, " ");
}

Json setup_json(const WorkbenchSetup& setup) {
  return Json::object()
      .set("runs", setup.runs)
      .set("holdouts", setup.holdouts)
      .set("reading", setup.reading)
      .set("notes", setup.notes)
      .set("model", setup.model.empty() ? Json() : Json(setup.model));
}

}  // namespace

std::string why_no_workbench() {
  if (embedded_engine().module.empty()) {
    return "this fogcomp was built without its engine for pages: install emscripten and build it "
           "again";
  }
  if (plot_library_files().empty()) {
    return "this fogcomp was built without the library that draws: install npm and build it again";
  }
  return "";
}

std::string workbench_page(const WorkbenchSetup& setup) {
  const std::string missing = why_no_workbench();
  if (!missing.empty()) throw InputError("workbench", missing);
  std::string files;
  for (const WorkbenchSetup::File& file : setup.files) files += file_element(file);
  std::string script;
  for (const EmbeddedFile& part : workbench_files()) {
    if (part.name[1] == '_') script += part.text;  // in the order of their first letters
  }
  const std::vector<EmbeddedFile>& basis = plot_library_files();
  const EmbeddedEngine engine = embedded_engine();
  return filled(file_of(workbench_files(), "frame"),
                {
                    {"subject", escaped(subject_of(setup))},
                    {"style", file_of(basis, "style") + file_of(page_files(), "style") +
                                  file_of(workbench_files(), "style")},
                    {"setup", script_data(setup_json(setup))},
                    {"files", files},
                    {"engine", std::string(engine.module)},
                    {"engine_script", std::string(engine.script)},
                    {"worker", file_of(workbench_files(), "worker")},
                    {"licence", file_of(basis, "licence")},
                    {"library", file_of(basis, "script")},
                    {"script", script},
                });
}

}  // namespace fogcomp::report
