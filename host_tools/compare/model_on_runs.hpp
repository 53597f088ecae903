#pragma once

#include <string>
#include <vector>

#include "compare/board_delay.hpp"
#include "compare/comparison.hpp"
#include "compare/residual_analysis.hpp"

namespace fogcomp::compare {

struct ModelOnRun {
  Comparison comparison;
  ResidualAnalysis analysis;
  BoardError error;  ///< of the whole run
};

/// Throws InputError where the run lacks a column that the model needs.
ModelOnRun try_model(const model::Model& model, const RunInBlocks& run);

/// One model on every run, in the order of the command line.
struct ModelOnRuns {
  std::string file;
  model::Model model;
  std::vector<ModelOnRun> runs;
};

/// Whether the noise floor lies above the residual by more than its own uncertainty.
bool is_below_floor(const Comparison& comparison);

}  // namespace fogcomp::compare
