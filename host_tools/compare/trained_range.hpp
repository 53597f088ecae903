#pragma once

#include "model/model.hpp"

namespace fogcomp::compare {

/// Fractions of a run's rows (0..1) outside the training data.
struct OutsideTraining {
  double temperature = 0;  ///< the board clamps there: the drift is constant
  double temperature_rate =
      0;  ///< ramps faster than all trained ones: rate terms and network extrapolate
  /// Earlier after power-on than all training rows: an untrained warm-up.
  double sooner = 0;
  /// Later than all, for models with an effect of the time since power-on.
  double later = 0;
};

/// Counts rows outside a model's trained ranges; ranges that the model lacks are not checked.
class TrainedRange {
 public:
  /// `row_s`: length of a row, which is also the tolerance in time.
  TrainedRange(const model::Model& model, double row_s);

  void count(double time_s, double temperature_degc, double rate_degc_per_min);
  /// Fractions of the rows counted.
  OutsideTraining outside() const;

 private:
  model::Range degc_;
  model::Range rate_;
  model::Range time_;
  double rows_ = 0;
  OutsideTraining rows_outside_;
};

}  // namespace fogcomp::compare
