#pragma once

#include <string>
#include <vector>

#include "evaluation/model_on_runs.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// Everything that is known of one run, for one or several models: a heading, words, segments, and
/// the plots. `run`: which of the runs; plots of different runs are not linked.
void add_run(Report& report, const std::vector<ModelOnRuns>& models, std::size_t run);

/// The runs' files as on a command line, each with a space before it.
std::string run_files(const ModelOnRuns& model);

/// Whether what a model leaves of a run lies above the noise floor beyond doubt.
bool leaves_drift(const ModelOnRun& run);

}  // namespace fogcomp::report
