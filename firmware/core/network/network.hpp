#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/effects/effect_bank.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/span.hpp"
#include "core/thermal/signals.hpp"

namespace fog {

enum class Activation : std::int32_t { logsig = 0, tansig = 1, linear = 2 };

/// A signal that a network can have as input; its number in the model table.
enum class NetworkInput : std::int32_t { temperature = 0, temperature_rate = 1 };

constexpr std::size_t kMostNetworkInputs = 2;
constexpr std::size_t kMostHidden = 32;

/// x -> (x - centre) * gain, clipped to +-1: the min-max normalisation of training.
struct InputScaling {
  NetworkInput signal{};
  std::int32_t centre = 0;         ///< in the format of the signal
  Fixed<std::int32_t, 28> gain{};  ///< per degC or per degC/min, below 8
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
};

/// The network's part of the drift. Stateless; least = most work for a given shape.
DriftSum network_drift(const NetworkParameters& network, int coefficient_fraction,
                       const Signals<BoardNumbers>& signals);

/// Whether every neuron's sum fits: for each row, sum |weight| + |bias| must be at most 2^31 in
/// raw, so that with inputs within +-1 at 30 fractional bits it stays below 2^61.
bool layer_fits(const LayerParameters& layer);

}  // namespace fog
