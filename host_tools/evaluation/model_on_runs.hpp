#pragma once

#include <string>
#include <vector>

#include "evaluation/comparison.hpp"
#include "evaluation/residual_analysis.hpp"

namespace fogcomp {

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

/// What is left of a run's drift, in half a sentence.
std::string error_words(const Comparison& comparison);

/// On what the residual depends beyond noise: largest share first, but time last, as anything slow
/// is a function of time.
std::string structure_words(const ModelOnRun& run);

/// A sentence for each kind of rows that the model never saw in training.
std::vector<std::string> range_warnings(const Comparison& comparison, const Model& model);

}  // namespace fogcomp
