#pragma once

#include <vector>

#include "compare/comparison.hpp"
#include "model/model.hpp"
#include "recording/row_range.hpp"

namespace fogcomp::fit {

/// Whether the sum of squares on runs rises from one model to another by more than chance does once
/// in 100 times (rules::kOneIn100).
class RiseTest {
 public:
  /// `run_offsets`: the bias of a power-on is its own and says nothing.
  explicit RiseTest(bool run_offsets) : run_offsets_(run_offsets) {}

  /// The same run with both models.
  void add(const compare::Comparison& before, const compare::Comparison& after);
  bool rose() const;
  /// Of all runs together; with at least one.
  model::HistoryEntry::Holdout rms_dph() const;

 private:
  bool run_offsets_;
  std::vector<double> rise_;
  std::vector<recording::RowRange> runs_;
  double before_ = 0;
  double after_ = 0;
  double weight_ = 0;
};

}  // namespace fogcomp::fit
