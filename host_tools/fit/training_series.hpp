#pragma once

#include "fit/known_regressors.hpp"
#include "fit/training_runs.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Training runs as fits see them, with the regressors known so far: several fits of one set of
/// runs share it.
class TrainingSeries {
 public:
  /// `model` defines derivative and averaging. Throws InputError if a run lacks an input of one of
  /// its effects.
  TrainingSeries(const model::Model& model, const TrainingRuns& training);
  // The members refer to each other.
  TrainingSeries(const TrainingSeries&) = delete;
  TrainingSeries& operator=(const TrainingSeries&) = delete;

  const KnownRegressors& known() const { return known_; }

 private:
  model::Model model_;
  series::SignalSeries series_;
  KnownRegressors known_;
};

}  // namespace fogcomp::fit
