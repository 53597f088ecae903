#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/signal/status.hpp"
#include "workflow/replay.hpp"

namespace fogcomp::workflow {

/// `weights` is a model; a header will do with `on_board`.
struct ApplyRequest : ReplayRequest {
  bool on_board = false;  ///< by the board's own code and integers
};

/// Who gets the series.
struct SeriesSink {
  struct Column {
    std::string name;
    int decimals;  ///< that show all that is known of it
  };
  /// Once, before the first row.
  std::function<void(const std::vector<Column>& columns)> begin{};
  /// In the order of the columns, NaN where there is none; what speaks against the row.
  std::function<void(const std::vector<double>& values, fog::Status flags)> row{};
};

struct ApplyOutcome {
  std::size_t rows = 0;
  std::size_t without_rate = 0;  ///< rows without a compensated rate that is valid
  std::size_t clamped = 0;       ///< outside the trained temperatures
  double raw_std_dph = 0;        ///< of the rows with a rate; input rate, if it is known, taken off
  double compensated_std_dph = 0;
};

/// A model on a recording, row by row: what was measured, the part of each effect and of the
/// network, their sum, the compensated rate. As the board computes it: a drift holds for a block of
/// 1 s and knows what was before it; in double, or, on_board, the integers that replay() sends.
/// Throws InputError as compare() and replay() do.
ApplyOutcome apply(const ApplyRequest& request, const SeriesSink& sink,
                   const Observer& observer = {});

}  // namespace fogcomp::workflow
