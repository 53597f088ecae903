#pragma once

#include <string>
#include <vector>

#include "support/embedded_file.hpp"

namespace fogcomp::report {

/// host_tools/report/page/: frame, style, plots.
const std::vector<EmbeddedFile>& page_files();

/// host_tools/report/workbench/: the same of the workbench, its script in parts.
const std::vector<EmbeddedFile>& workbench_files();

/// uPlot as npm has it: script, style, licence; empty where npm was not to be had at build time.
const std::vector<EmbeddedFile>& plot_library_files();

}  // namespace fogcomp::report
