#pragma once

#include "model/model.hpp"

namespace fogcomp::compare {

/// Parts of a run's rows (0..1) that lie where the training data never was.
struct OutsideTraining {
  double temperature = 0;       ///< the board clamps there: the drift stands still
  double temperature_rate = 0;  ///< ramps faster than any trained: rate terms and network guess
  /// Sooner after power-on than any training row: warm-up that no effect has seen.
  double sooner = 0;
  /// Later than any, for models with an effect of the time since power-on.
  double later = 0;
};

/// Counts rows against a model's trained ranges; those that a model does not have count nothing.
class TrainedRange {
 public:
  /// `row_s`: length of a row; as much is allowed beyond the range of time.
  TrainedRange(const model::Model& model, double row_s);

  void count(double time_s, double temperature_degc, double rate_degc_per_min);
  /// Of the rows counted.
  OutsideTraining outside() const;

 private:
  model::Range degc_;
  model::Range rate_;
  model::Range time_;
  double rows_ = 0;
  OutsideTraining rows_outside_;
};

}  // namespace fogcomp::compare
