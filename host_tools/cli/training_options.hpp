#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "fit/fit_model.hpp"
#include "support/interrupt.hpp"
#include "support/progress.hpp"

namespace fogcomp::cli {

/// --network, --trainer and what belongs to them.
std::vector<Option> training_options();
/// `hidden` is 0 where no network is wanted.
NetworkSettings network_settings(const Arguments& arguments);

/// Whether a network was judged worth keeping, in a line; "" where none was judged.
std::string network_verdict(const FitResult& fit);

/// While one lives, a training shows a progress bar, and Ctrl-C ends it with the best weights so
/// far. Before the training, Ctrl-C ends the program as ever.
class TrainingWatch {
 public:
  /// `settings` is what the training will get.
  explicit TrainingWatch(TrainerSettings& settings);
  /// Says on stderr where the training was interrupted.
  void report(const TrainerResult& result) const;

 private:
  Progress progress_;
  std::optional<InterruptGuard> guard_;
};

}  // namespace fogcomp::cli
