#pragma once

#include <string>
#include <vector>

#include "evaluation/comparison.hpp"
#include "evaluation/residual_analysis.hpp"

namespace fogcomp::cli {

struct ModelOnRun {
  Comparison comparison;
  ResidualAnalysis analysis;
};

/// One model on every run, in the order of the command line.
struct ModelOnRuns {
  std::string file;
  Model model;
  std::vector<ModelOnRun> runs;
};

/// A line for each run and model, what is still in the residual, warnings; then the segments.
/// Several models stand side by side. `details` adds effects, dependences, Allan deviation and
/// autocorrelation of each.
std::string compare_text(const std::vector<ModelOnRuns>& models, bool details);

}  // namespace fogcomp::cli
