#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/document.hpp"

/// What is said and drawn of a run under one or several models.
namespace fogcomp::findings {

/// The best first; never empty.
using Models = std::vector<const compare::ModelOnRuns*>;

const compare::Comparison& on_run(const compare::ModelOnRuns& model, std::size_t run);

/// A single model is named `alone`, by its kind; several are named by their files.
std::vector<Text> labels(const Models& models, const Text& alone);

/// Colour of a model's residual: the best one has that of a single model.
std::string residual_colour(std::size_t model);
Look look_of(std::size_t model);

/// Everything about one run: a heading, sentences, segments, and plots. `models`: the best first;
/// segments, dependences and contributions are those of the best. `run`: index of the run; plots of
/// different runs are not linked. `shown`: place of its sentences and main table.
Parts run_section(const Models& models, std::size_t run, Shown shown);

/// What is left of a run, before and after the models: against the band that the best model
/// promises, its Allan deviation in soaks and over the whole run, spectrum, distribution,
/// correlation, and scale-factor error. Those for which the run suffices.
std::vector<Plot> residual_plots(const Models& models, std::size_t run);

/// The plots of a run as values for a terminal: dependences, loop, Allan deviation,
/// autocorrelation.
Parts run_details(const compare::ModelOnRun& judged);

/// The runs' files for a command line, each preceded by a space.
std::vector<std::string> run_files(const compare::ModelOnRuns& model);

/// The words of a command that diagnoses the model.
std::vector<std::string> diagnose_command(const std::string& model,
                                          const std::vector<std::string>& runs,
                                          const std::vector<std::string>& holdouts = {});

/// That command, for a model that leaves drift; another way where it would refuse so few rows.
Next next_diagnosis(const compare::ModelOnRuns& model);

/// Whether a model's residual is significantly above the noise floor on one of its runs.
bool leaves_drift(const compare::ModelOnRuns& model);
/// Whether nobody can say of one of them, as of a table of few means.
bool floor_is_unknown(const compare::ModelOnRuns& model);

}  // namespace fogcomp::findings
