#pragma once

#include <string_view>

namespace fogcomp::report {

/// The workbench's engine (workbench/engine/): WebAssembly, packed by gzip, as base64, and
/// emscripten's script that starts it; both empty where emscripten was not there at build time.
struct EmbeddedEngine {
  std::string_view module;
  std::string_view script;
};
EmbeddedEngine embedded_engine();

}  // namespace fogcomp::report
