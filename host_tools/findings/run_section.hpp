#pragma once

#include <string>
#include <vector>

#include "findings/compared_models.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// Adds everything about one run: a heading, sentences, segments, and plots. `models`: the best
/// first; segments, dependences and contributions are those of the best. `run`: index of the run;
/// plots of different runs are not linked. `shown`: place of its sentences and main table.
void add_run(Document& document, const Models& models, std::size_t run, Shown shown);

/// The runs' files for a command line, each preceded by a space.
std::vector<std::string> run_files(const compare::ModelOnRuns& model);

/// The words of a command that diagnoses the model.
std::vector<std::string> diagnose_command(const std::string& model,
                                          const std::vector<std::string>& runs);

/// Whether a model's residual on a run is significantly above the noise floor.
bool leaves_drift(const compare::ModelOnRun& run);

}  // namespace fogcomp::findings
