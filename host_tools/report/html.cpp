#include "report/html.hpp"

#include <algorithm>
#include <stdexcept>

#include "report/embedded_page.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// JSON as the content of a <script> element, without "<", so that it cannot end the element.
std::string script_data(const Json& json) {
  std::string text = json.text();
  replace_all(text, "<", "\\u003c");
  return text;
}

// The text of the embedded file `name`. Throws std::logic_error if it is not among `files`.
const std::string& file_of(const std::vector<EmbeddedFile>& files, const std::string& name) {
  for (const EmbeddedFile& one : files) {
    if (one.name == name) return one.text;
  }
  throw std::logic_error("no file '" + name + "' was compiled in");
}

// `frame` with each {{name}} replaced by the part of that name. Throws std::logic_error if a part
// is missing.
std::string filled(const std::string& frame,
                   const std::vector<std::pair<std::string, std::string>>& parts) {
  std::string page;
  std::size_t at = 0;
  while (true) {
    const std::size_t open = frame.find("{{", at);
    page.append(frame, at, open - at);
    if (open == std::string::npos) return page;
    const std::size_t close = frame.find("}}", open);
    const std::string name = frame.substr(open + 2, close - open - 2);
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const auto& one) { return one.first == name; });
    if (part == parts.end()) throw std::logic_error("no part '" + name + "' for the page");
    page += part->second;
    at = close + 2;
  }
}

using Parts = std::vector<std::pair<std::string, std::string>>;

std::string file_element(const WorkbenchSetup::File& file) {
  return "<script type=\"text/plain\" data-file=\"" + escaped(file.name) + "\">" +
         base64(file.bytes) + "</script>\n";
}

Json state_json(const WorkbenchSetup::State& state) {
  Json json = Json::object();
  json.set("model", state.model).set("label", state.label).set("words", state.words);
  json.set("judgement", state.judgement).set("accepted", state.accepted);
  return json;
}

Json setup_json(const WorkbenchSetup& setup) {
  return Json::object()
      .set("runs", setup.runs)
      .set("holdouts", setup.holdouts)
      .set("reading", setup.reading)
      .set("masks", setup.masks)
      .set("notes", setup.notes)
      .set("states", json_array(setup.states, state_json));
}

// The files of workbench/ that begin with "a_", "b_", ... in that order; the others are parts of
// the page.
std::string workbench_script() {
  std::string script;
  for (const EmbeddedFile& part : workbench_files()) {
    if (part.name[1] == '_') script += part.text;
  }
  return script;
}

std::string bench_element(const WorkbenchSetup& setup) {
  std::string files;
  for (const WorkbenchSetup::File& file : setup.files) files += file_element(file);
  const EmbeddedEngine engine = embedded_engine();
  return filled(file_of(workbench_files(), "bench"),
                {
                    {"setup", script_data(setup_json(setup))},
                    {"files", files},
                    {"engine", std::string(engine.module)},
                    {"engine_script", std::string(engine.script)},
                    {"worker", file_of(workbench_files(), "worker")},
                });
}

Parts bench_parts(const PageContent& content) {
  if (content.bench == nullptr) return {{"header", ""}, {"bench", ""}, {"policy", ""}};
  return {{"header",
           filled(file_of(workbench_files(), "header"), {{"subject", escaped(content.subject)}})},
          {"bench", bench_element(*content.bench)},
          {"policy", " 'wasm-unsafe-eval'; worker-src blob:"}};
}

const char* without_scripts(const PageContent& content) {
  return content.report.empty()
             ? "The workbench calculates in this page, so it needs a browser that allows scripts. "
               "Reports can be read without scripts."
             : "With scripts allowed, plots can be zoomed and their curves hidden.";
}

// Style sheet and scripts; a page without plots and workbench has no script.
Parts script_parts(const PageContent& content) {
  const std::vector<EmbeddedFile>& library = plot_library_files();
  const std::string& style = file_of(page_files(), "style");
  const bool has_bench = content.bench != nullptr;
  if (library.empty() || !(content.draws || has_bench)) {
    return {{"style", style}, {"licence", ""}, {"library", ""}, {"script", ""}};
  }
  return {{"style", file_of(library, "style") + style +
                        (has_bench ? file_of(workbench_files(), "style") : "")},
          {"licence", file_of(library, "licence")},
          {"library", file_of(library, "script")},
          {"script", file_of(page_files(), "drawing") + file_of(page_files(), "plots") +
                         (has_bench ? workbench_script() : "")}};
}

}  // namespace

std::string escaped(std::string text) {
  text = valid_utf8(text);
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, ">", "&gt;");
  replace_all(text, "\"", "&quot;");
  return text;
}

std::string escaped(const findings::Text& text) {
  return escaped(text.typeset());
}

std::string framed(const PageContent& content) {
  Parts parts{{"subject", escaped(content.subject)},
              {"report", content.report},
              {"without_scripts", without_scripts(content)},
              {"data", script_data(content.plots)}};
  for (const Parts& more : {bench_parts(content), script_parts(content)}) {
    parts.insert(parts.end(), more.begin(), more.end());
  }
  return filled(file_of(page_files(), "frame"), parts);
}

}  // namespace fogcomp::report
