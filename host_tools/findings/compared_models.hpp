#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/plot.hpp"

/// How plots and sentences tell several models on the same run apart.
namespace fogcomp::findings {

/// The best first; never empty.
using Models = std::vector<const compare::ModelOnRuns*>;

const compare::Comparison& on_run(const compare::ModelOnRuns& model, std::size_t run);

/// A single model is named `alone`, by its kind; several are named by their files.
std::vector<Text> labels(const Models& models, const Text& alone);

/// Colour of a model's residual: the best one has that of a single model.
std::string residual_colour(std::size_t model);
Look look_of(std::size_t model);

}  // namespace fogcomp::findings
