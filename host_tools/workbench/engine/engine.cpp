// The engine's interface to report/workbench/worker.js: two functions on one session.

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

/// Session::answer() for `words` separated by line ends. The result is valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* fogcomp_call(const char* words) {
  static std::string answer;
  answer = session().answer(fogcomp::split(words, '\n'));
  return answer.c_str();
}

/// Session::column() with the number of its values in `count`; nullptr and 0 if there is none.
/// Valid until the next call of fogcomp_call().
EMSCRIPTEN_KEEPALIVE const double* fogcomp_column(int run, const char* name, int* count) {
  const std::vector<double>* const column = session().column(static_cast<std::size_t>(run), name);
  *count = column == nullptr ? 0 : static_cast<int>(column->size());
  return column == nullptr ? nullptr : column->data();
}
}
