#pragma once

#include <string>
#include <vector>

#include "network/network_training.hpp"
#include "series/signal_series.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {

/// Values of FitRequest::preset: models of the literature that a board can run.
std::vector<std::string> preset_names();

/// Whether the preset, or none, uses FitRequest::effects. Throws InputError for a model that no
/// board can run, or an unknown one.
bool takes_effects(const std::optional<std::string>& preset);

/// The effects and the network of a request.
struct WantedModel {
  std::string effects;
  network::NetworkSettings network;   ///< 0 hidden neurons: none
  bool network_is_the_model = false;  ///< there is nothing to compare it with
  bool order_by_validation = false;   ///< of bias_temperature
};

/// Throws InputError if preset and another member contradict.
WantedModel wanted_model(const FitRequest& request);

/// The terms of its effects and expressions, without coefficients. Throws InputError like
/// wanted_model(), parse_effects() and add_expression().
std::vector<model::EffectTerm> wanted_terms(const FitRequest& request);

/// Sets the polynomial's order, 1 to 9, by cross-validation.
void choose_order(std::vector<model::EffectTerm>& terms, const series::Rows& rows);

}  // namespace fogcomp::workflow
