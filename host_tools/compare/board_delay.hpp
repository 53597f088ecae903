#pragma once

#include <string>

#include "compare/comparison.hpp"
#include "model/model.hpp"
#include "runs/run.hpp"

namespace fogcomp::compare {

/// Error of a model as the board computes it, and without the board's delay with the gyro's own
/// values: rms of the rows that count, deg/h.
struct BoardError {
  double rms_dph = 0;
  double without_delay_dph = 0;
  double rows = 0;  ///< total duration, in full rows

  /// Combines several runs.
  void add(const BoardError& other);
  /// Whether the delay makes more than 1 % of the error: then both are printed.
  bool delay_matters() const;
};

/// "as the board computes it the residual is 1062, without the board's delay (...) 166.8 deg/h".
std::string delay_words(const BoardError& error);

/// `comparison`: of this model on this run.
BoardError board_error(const model::Model& model, const runs::Run& run,
                       const Comparison& comparison);

}  // namespace fogcomp::compare
