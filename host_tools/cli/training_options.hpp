#pragma once

#include <vector>

#include "cli/arguments.hpp"
#include "training/network_training.hpp"

namespace fogcomp::cli {

/// --network, --trainer and what belongs to them.
std::vector<Option> training_options();
/// `hidden` is 0 where no network is wanted.
NetworkSettings network_settings(const Arguments& arguments);

/// train_network() with a progress bar; Ctrl-C ends it with the best weights so far, and says so.
TrainedNetwork train_watched(const NetworkTask& task, NetworkSettings settings);

}  // namespace fogcomp::cli
