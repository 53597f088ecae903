#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/signal/status.hpp"
#include "workflow/replay.hpp"

namespace fogcomp::workflow {

/// `weights` is a model; with `on_board` also a header.
struct ApplyRequest : ReplayRequest {
  bool on_board = false;  ///< by the board's own code, in integers
};

/// Receiver of the series.
struct SeriesSink {
  struct Column {
    std::string name;
    int decimals;  ///< enough for the exact value
  };
  /// Called once, before the first row.
  std::function<void(const std::vector<Column>& columns)> begin{};
  /// Called with the values in the order of the columns, NaN if missing, and the flags of the row.
  std::function<void(const std::vector<double>& values, fog::Status flags)> row{};
};

struct ApplyOutcome {
  std::size_t rows = 0;
  std::size_t without_rate = 0;  ///< rows without a valid compensated rate
  std::size_t clamped = 0;       ///< outside the trained temperatures
  double raw_std_dph = 0;        ///< of unmasked rows with a rate, less a known input rate
  double compensated_std_dph = 0;
};

/// Applies a model to a recording, row by row: measured values, contribution of each effect and of
/// the network, their sum, compensated rate, and the standard deviation of the drift if the model
/// knows it (series/signal_series.hpp). Computed like on the board: a drift is valid for a
/// block of 1 s and uses earlier data only; in double or, on_board, the integers of replay().
/// Throws InputError like compare() and replay().
ApplyOutcome apply(const ApplyRequest& request, const SeriesSink& sink,
                   const Observer& observer = {});

}  // namespace fogcomp::workflow
