#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// Everything that is known of one run: a heading, words, segments, and the plots. `models`: the
/// best first; what only one model can have (segments, dependences, parts) is of that one. `run`:
/// which of the runs; plots of different runs are not linked. `shown`: where its words and
/// its main table are.
void add_run(Document& document, const std::vector<const compare::ModelOnRuns*>& models,
             std::size_t run, Shown shown);

/// The runs' files as on a command line, each with a space before it.
std::vector<std::string> run_files(const compare::ModelOnRuns& model);

/// The words that ask what a model lacks.
std::vector<std::string> diagnose_command(const std::string& model,
                                          const std::vector<std::string>& runs);

/// Whether what a model leaves of a run lies above the noise floor beyond doubt.
bool leaves_drift(const compare::ModelOnRun& run);

}  // namespace fogcomp::findings
