#pragma once

#include <optional>
#include <vector>

#include "compare/run_in_blocks.hpp"
#include "denoise/denoise.hpp"
#include "fit/identify.hpp"
#include "fit/residual_network.hpp"

namespace fogcomp::fit {

struct FitSettings {
  IdentifySettings identify;
  NetworkSettings network;     ///< hidden 0: no network
  bool force_network = false;  ///< it stays, whether or not it helps out of sample
  std::vector<model::RealInput> network_inputs{{fog::NetworkInput::temperature},
                                               {fog::NetworkInput::temperature_rate}};
  /// What the network is trained on is denoised first; nothing: the rows stay as they are.
  std::optional<denoise::DenoiseMethod> row_denoising;
};

struct FitResult {
  double raw_std_dph = 0;  ///< of the rows, before any model
  /// What the effects leave. With the network on top: Model::residual_rms_dph.
  double effects_rms_dph = 0;
  Identification identified;
  std::optional<TrainerResult> training;      ///< of the network, kept or not
  std::optional<OutOfSample> network_judged;  ///< nothing without a network, or where it is forced
};

/// Both stages on all rows of `series`: the effects of model.terms, all together, then a new
/// network on what they leave, which is kept if it helps out of sample (residual_network.hpp). The
/// model's network, trained range and residual are replaced; its
/// history is the caller's. Throws InputError as identify() does.
FitResult fit_model(model::Model& model, const series::SignalSeries& series,
                    const FitSettings& settings);

}  // namespace fogcomp::fit
