#pragma once

#include <string>
#include <vector>

#include "fit/network_training.hpp"
#include "series/signal_series.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {

/// What FitRequest::preset takes: models of the literature that a board can carry.
std::vector<std::string> preset_names();

/// Whether the preset leaves the effects to FitRequest::effects, as none does. Throws InputError
/// for a model that no board can carry, or that nobody knows.
bool takes_effects(const std::optional<std::string>& preset);

/// What a request asks for: effects and a network.
struct WantedModel {
  std::string effects;
  fit::NetworkSettings network;       ///< 0 hidden neurons: none
  bool network_is_the_model = false;  ///< nothing to judge it against
  bool order_by_validation = false;   ///< of bias_temperature
};

/// Throws InputError where preset and another member contradict.
WantedModel wanted_model(const FitRequest& request);

/// The terms of its effects and expressions, without coefficients. Throws InputError as
/// wanted_model(), parse_effects() and add_expression() do.
std::vector<model::EffectTerm> wanted_terms(const FitRequest& request);

/// Sets the polynomial's order from 1 to 9 to the one that predicts best what it was not fitted to.
void choose_order(std::vector<model::EffectTerm>& terms, const series::Rows& rows);

}  // namespace fogcomp::workflow
