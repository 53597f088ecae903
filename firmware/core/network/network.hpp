#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/effects/effect_bank.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/network/network_input.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/span.hpp"
#include "core/thermal/first_order_lag.hpp"

namespace fog {

enum class Activation : std::int32_t { logsig = 0, tansig = 1, linear = 2 };

constexpr std::size_t kMostHidden = 32;

/// x -> (x - centre) * multiplier / 2^shift, clipped to +-1: the min-max normalisation of training.
struct InputScaling {
  NetworkInput signal{};
  FirstOrderLag<BoardNumbers>::Decay decay{};  ///< of lagged_temperature; 0 for the others
  std::int32_t centre = 0;                     ///< in the format of the signal
  std::int32_t multiplier = 0;                 ///< 2^30 <= multiplier < 2^31: 30 significant bits
  int shift = 0;                               ///< 0 to 62; gives ActivationOutput's fraction
};

/// One dense layer: outputs = activation(weights * inputs + biases).
struct LayerParameters {
  Span<const std::int32_t> weights;  ///< outputs x inputs, row after row
  Span<const std::int32_t> biases;   ///< one per output
  int fraction = 0;                  ///< fractional bits of weights and biases
  Activation activation{};
};

/// inputs -> hidden -> one output y; drift = centre + amplitude * y. No hidden neurons: no network.
struct NetworkParameters {
  std::array<InputScaling, kMostNetworkInputs> inputs{};
  std::size_t input_count = 0;
  LayerParameters hidden;
  LayerParameters output;
  std::int32_t centre = 0;     ///< deg/h, EffectsParameters::coefficient_fraction bits
  std::int32_t amplitude = 0;  ///< the same

  bool present() const { return hidden.biases.size != 0; }
  NetworkInputMask used() const {
    NetworkInputMask mask = 0;
    for (std::size_t i = 0; present() && i < input_count; ++i) mask |= bit_of(inputs[i].signal);
    return mask;
  }
};

/// The raw value of a signal as the network takes it, within +-1.
ActivationOutput normalised(std::int32_t raw, const InputScaling& scaling);

/// The drift of a network that is present, from the raw numbers of its normalised inputs.
/// Stateless; least = most work for a given shape, but for the branches of the activation
/// functions.
DriftSum network_drift(const NetworkParameters& network, int coefficient_fraction,
                       const std::int32_t* inputs);

/// Whether every neuron's sum fits: for each row, sum |weight| + |bias| must be at most 2^31 in
/// raw, so that with inputs within +-1 at 30 fractional bits it stays below 2^61.
bool layer_fits(const LayerParameters& layer);

}  // namespace fog
