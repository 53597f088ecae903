#pragma once

#include <string>
#include <vector>

#include "compare/board_delay.hpp"
#include "compare/comparison.hpp"
#include "compare/residual_analysis.hpp"

namespace fogcomp {

struct ModelOnRun {
  Comparison comparison;
  ResidualAnalysis analysis;
  BoardError error;  ///< of the whole run
};

/// Throws InputError where the run lacks a column that the model needs.
ModelOnRun try_model(const Model& model, const RunInBlocks& run);

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

/// What has to be known with the figures, a half sentence each: rows left out, what the board's
/// delay makes of the residual, a noise floor that cannot be right.
std::vector<std::string> remarks(const ModelOnRun& run);

/// Whether the noise floor lies above the residual by more than its own uncertainty.
bool is_below_floor(const Comparison& comparison);

/// A sentence for each kind of rows that the model never saw in training.
std::vector<std::string> range_warnings(const Comparison& comparison, const Model& model);

}  // namespace fogcomp
