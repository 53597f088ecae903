#pragma once

#include <string_view>

namespace fogcomp::report {

/// The workbench's engine (workbench/engine/): the WebAssembly module (gzip, then base64) and
/// emscripten's loader script. Both are empty if emscripten was missing at build time.
struct EmbeddedEngine {
  std::string_view module;
  std::string_view script;
};
EmbeddedEngine embedded_engine();

}  // namespace fogcomp::report
