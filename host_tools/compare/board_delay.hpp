#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "compare/run_in_blocks.hpp"
#include "model/model.hpp"

namespace fogcomp::compare {

/// How much of a fit's error is the board's delay: rms over all rows, deg/h, of what the effects
/// make of signals as the board has them (means of the block before, causal derivative) less what
/// they make of signals without delay (zero_phase.hpp).
double delay_error_dph(const model::Model& model, const std::vector<RunInBlocks>& runs);

/// Error of a model as the board computes it, and how large it would be without the board's delay,
/// the model's coefficients the same: rms of the rows that count, deg/h.
struct BoardError {
  double rms_dph = 0;
  double without_delay_dph = 0;
  double rows = 0;  ///< time behind both, relative to a full row

  /// Of several runs together.
  void add(const BoardError& other);
  /// Whether the two figures differ enough to be told apart in print: by more than 1 %.
  bool delay_matters() const;
};

/// "as the board computes it the residual is 1062, without the board's delay (...) 166.8 deg/h".
std::string delay_words(const BoardError& error);

/// `comparison`: of this model with this run.
BoardError board_error(const model::Model& model, const RunInBlocks& run,
                       const Comparison& comparison);

}  // namespace fogcomp::compare
