#pragma once

#include <optional>
#include <vector>

#include "denoise/denoise.hpp"
#include "fit/identify.hpp"
#include "fit/known_regressors.hpp"
#include "fit/residual_network.hpp"
#include "runs/run.hpp"

namespace fogcomp::fit {

struct FitSettings {
  IdentifySettings identify;
  network::NetworkSettings network;  ///< hidden 0: no network
  bool force_network = false;        ///< kept even if it does not help out of sample
  std::vector<model::RealInput> network_inputs{{fog::NetworkInput::temperature},
                                               {fog::NetworkInput::temperature_rate}};
  /// Denoising of the network's target before training; nothing: none.
  std::optional<denoise::DenoiseMethod> row_denoising;
};

struct FitResult {
  double raw_std_dph = 0;  ///< of the rows, before any model
  /// Residual of the effects. With the network: Model::residual_rms_dph.
  double effects_rms_dph = 0;
  Identification identified;
  std::optional<network::TrainerResult> training;  ///< of the network, kept or not
  std::optional<OutOfSample> network_judged;  ///< nothing without a network, or if it is forced
};

/// Fits the effects of model.terms together on all rows of the series. Replaces the model's trained
/// range and residual and removes its network; the caller updates its history. Throws InputError
/// like identify().
FitResult fit_effects(model::Model& model, const KnownRegressors& known,
                      const IdentifySettings& settings);

/// Trains a new network, if one is wanted, on what the effects leave: `result` is fit_effects() of
/// the same model and rows. It is kept if it helps out of sample (residual_network.hpp).
void fit_network(model::Model& model, const KnownRegressors& known, const FitSettings& settings,
                 FitResult& result);

/// Both.
FitResult fit_model(model::Model& model, const KnownRegressors& known, const FitSettings& settings);

}  // namespace fogcomp::fit
