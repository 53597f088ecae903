#pragma once

#include <string>
#include <vector>

#include "fit/network_training.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::cli {

struct FitOptions;

/// What `fit --model NAME` stands for: effects and a network, as the board can carry them.
struct WantedModel {
  std::string effects;
  NetworkSettings network;            ///< 0 hidden neurons: none
  bool network_is_the_model = false;  ///< nothing to judge it against
  bool order_by_validation = false;   ///< of bias_temperature
};

/// --model, and --effects, --network, --trainer where the name leaves them open. Throws InputError
/// for a model that only `fogcomp paper` has, and where --model and another option contradict.
WantedModel wanted_model(const FitOptions& options);

/// The names that --model takes; as a list in words.
std::vector<std::string> fit_model_names();
std::string fit_model_list();

/// Sets the polynomial's order from 1 to 9 to the one that predicts best what it was not fitted to.
void choose_order(std::vector<EffectTerm>& terms, const Rows& rows);

}  // namespace fogcomp::cli
