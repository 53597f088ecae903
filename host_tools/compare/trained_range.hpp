#pragma once

#include <array>

#include "core/thermal/signals.hpp"
#include "model/model.hpp"
#include "model/real_numbers.hpp"

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
  double input_rate = 0;  ///< beyond the trained ones, for models that need it
  /// Beyond the trained values of an extension input that the model needs.
  std::array<double, fog::kExtensionInputs> inputs{};
};

/// Counts rows outside a model's trained ranges; ranges that the model lacks are not checked.
class TrainedRange {
 public:
  /// `row_s`: length of a row, which is also the tolerance in time.
  TrainedRange(const model::Model& model, double row_s);

  /// `inputs`: means of the row.
  void count(double time_s, const fog::BlockMeans<model::RealNumbers>& inputs,
             double rate_degc_per_min);
  /// Fractions of the rows counted.
  OutsideTraining outside() const;

 private:
  model::Range degc_;
  model::Range rate_;
  model::Range time_;
  model::Range input_rate_;
  std::array<model::Range, fog::kExtensionInputs> inputs_;
  double rows_ = 0;
  OutsideTraining rows_outside_;
};

}  // namespace fogcomp::compare
