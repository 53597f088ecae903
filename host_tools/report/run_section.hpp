#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// Everything that is known of one run: a heading, words, segments, and the plots. `models`: the
/// best first; what only one model can have (segments, dependences, parts) is of that one. `run`:
/// which of the runs; plots of different runs are not linked.
void add_run(Report& report, const std::vector<const ModelOnRuns*>& models, std::size_t run);

/// The runs' files as on a command line, each with a space before it.
std::string run_files(const ModelOnRuns& model);

/// "rms 0.0543 °/h left; a constant alone leaves 0.068, the noise floor is 0.0235": what is left of
/// a run, in half a sentence.
Text error_text(const Comparison& comparison);

/// Whether what a model leaves of a run lies above the noise floor beyond doubt.
bool leaves_drift(const ModelOnRun& run);

}  // namespace fogcomp::report
