#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fixed_point/logistic.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/network/network_input.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/span.hpp"
#include "core/signal/weighted_sum.hpp"
#include "core/thermal/first_order_lag.hpp"

namespace fog {

/// What a model may ask for. The board has one activation, tanh(z / 2); the factors in which logsig
/// and tansig differ from it go into weights and biases when the table is written.
enum class Activation : std::int32_t { logsig = 0, tansig = 1, linear = 2 };

constexpr std::size_t kMaxHidden = 32;

/// Fractional bits of weights, less the layer's shift; biases and sums have two less.
constexpr int kWeightFraction = 29;
constexpr int kMaxWeightShift = 16;

using NetworkDrift = Fixed<std::int32_t, 16>;  ///< deg/h, +-32768

/// x -> (x - centre, clipped to +-reach) * 2^shift: the min-max normalisation of training but for a
/// factor between 1 and 2, which is in the weights. Exact.
struct InputScaling {
  NetworkInput signal{};
  FirstOrderLag<BoardNumbers>::Decay decay{};  ///< of lagged_temperature; 0 for the others
  std::int32_t centre = 0;                     ///< in the format of the signal
  std::int32_t half_range = 0;                 ///< the same; 0: no input
  int shift = 0;                               ///< reach * 2^shift is below 2^31
};

/// A hidden neuron is so many words of the model table: its bias, its weights (0 for inputs that
/// the network does not have) and its weight in the output's sum.
constexpr std::size_t kNeuronWords = 1 + kMaxNetworkInputs + 1;

/// inputs -> hidden -> one output y; drift = centre + amplitude * y. No hidden neurons: no network.
struct NetworkParameters {
  std::array<InputScaling, kMaxNetworkInputs> inputs{};
  std::size_t input_count = 0;
  int hidden_shift = 0;              ///< of hidden neurons' biases and weights, 0..kMaxWeightShift
  int output_shift = 0;              ///< of the output's
  Span<const std::int32_t> neurons;  ///< kNeuronWords each
  std::int32_t output_bias = 0;
  bool linear_output = false;  ///< y is the output's sum, within +-2; else tanh(sum / 2)
  NetworkDrift centre{};
  NetworkDrift amplitude{};

  bool present() const { return neurons.size != 0; }
  NetworkInputMask used() const {
    NetworkInputMask mask = 0;
    for (std::size_t i = 0; present() && i < input_count; ++i) mask |= bit_of(inputs[i].signal);
    return mask;
  }
};

using ScaledInputs = std::array<std::int32_t, kMaxNetworkInputs>;  ///< 0 where there is none

/// The nearest value within +-reach; no branch, on the board neither.
inline std::int32_t clip(std::int32_t value, std::int32_t half_range) {
  value = value < half_range ? value : half_range;
  return value > -half_range ? value : -half_range;
}

/// The raw value of a signal as the network takes it.
inline std::int32_t scaled_input(std::int32_t raw, const InputScaling& scaling) {
  const std::int32_t difference = saturating_difference(raw, scaling.centre);
  return shift_left(clip(difference, scaling.half_range), scaling.shift);
}

/// The drift of a network that is present. Stateless; always the same number of instructions for a
/// number of neurons, with four inputs some more than with fewer.
DriftSum network_drift(const NetworkParameters& network, const ScaledInputs& inputs);

/// Whether no sum can leave 64 bits, whatever the inputs: in raw, sum |weight| + 2 |bias| < 2^32 -
/// 1 for every neuron, the output included.
bool network_fits(const NetworkParameters& network);

}  // namespace fog
