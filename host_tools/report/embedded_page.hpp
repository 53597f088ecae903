#pragma once

#include <string_view>
#include <vector>

#include "support/embedded_file.hpp"

namespace fogcomp::report {

/// Files of host_tools/report/page/: frame, style and scripts of every page.
const std::vector<EmbeddedFile>& page_files();

/// Files of host_tools/report/workbench/: HTML, style and scripts of the workbench.
const std::vector<EmbeddedFile>& workbench_files();

/// uPlot from npm: script, style, licence. Empty if npm was missing at build time.
const std::vector<EmbeddedFile>& plot_library_files();

/// The workbench's engine (workbench/engine/): the WebAssembly module (gzip, then base64) and
/// emscripten's loader script. Both are empty if emscripten was missing at build time.
struct EmbeddedEngine {
  std::string_view module;
  std::string_view script;
};
EmbeddedEngine embedded_engine();

}  // namespace fogcomp::report
