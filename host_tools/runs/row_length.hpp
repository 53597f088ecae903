#pragma once

#include <string>
#include <vector>

#include "runs/run.hpp"

namespace fogcomp::runs {

/// Rows in which residuals are diagnosed and additions are judged.
struct RowLength {
  double row_s = 0;
  std::string why;  ///< a line where it is neither the usual one nor the model's, else ""
};

/// The shortest of rules::kRowLengths_s, seconds, that does not make too many rows of so many
/// seconds.
double sufficient_row_s(double all_s);

/// The row length for these runs: whatever `model_row_s`, that of the model's fit, so that no
/// verdict depends on it (rules::kRowLengths_s). Only where it makes the same rows, or where a run
/// is so short that longer rows would be too few (rules::kMinRowsToJudge), `model_row_s` itself.
RowLength row_length(const std::vector<Run>& runs, double model_row_s);

}  // namespace fogcomp::runs
