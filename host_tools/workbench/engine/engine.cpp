// The session for a page: two functions that its script calls.

#include <emscripten.h>

#include <string>

#include "support/text.hpp"
#include "workbench/session.hpp"

// NOLINTNEXTLINE: emscripten's way to call the page
EM_JS(void, tell_progress, (const char* stage, double done),
      { Module.progress(UTF8ToString(stage), done); });

namespace {

fogcomp::workbench::Session& session() {
  static fogcomp::workbench::Session one({{}, {}, [](const std::string& stage, double done) {
                                            tell_progress(stage.c_str(), done);
                                            return true;
                                          }});
  return one;
}

}  // namespace

extern "C" {

/// `words`: separated by line ends. The answer stays until the next call.
EMSCRIPTEN_KEEPALIVE const char* fogcomp_call(const char* words) {
  static std::string answer;
  answer = session().answer(fogcomp::split(words, '\n'));
  return answer.c_str();
}

/// A column of the session, and how many values it has; nullptr where there is none.
EMSCRIPTEN_KEEPALIVE const double* fogcomp_column(int run, const char* name, int* count) {
  const std::vector<double>* const column = session().column(static_cast<std::size_t>(run), name);
  *count = column == nullptr ? 0 : static_cast<int>(column->size());
  return column == nullptr ? nullptr : column->data();
}
}
