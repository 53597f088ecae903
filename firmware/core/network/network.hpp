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

/// Activations of a model. The board computes only tanh(z / 2); when the table is written, weights
/// and biases absorb the factors in which logsig and tansig differ from it.
enum class Activation : std::int32_t { logsig = 0, tansig = 1, linear = 2 };

constexpr std::size_t kMaxHidden = 32;

/// Fractional bits of weights, less the shift of the layer; biases and sums have two fewer.
constexpr int kWeightFraction = 29;
constexpr int kMaxWeightShift = 16;

using NetworkDrift = Fixed<std::int32_t, 16>;  ///< deg/h, +-32768

/// x -> (x - centre, clipped to +-half_range) * 2^shift: the min-max normalisation of training up
/// to a factor between 1 and 2, which the weights include. Exact.
struct InputScaling {
  NetworkInput signal{};
  FirstOrderLag<BoardNumbers>::Decay decay{};  ///< of lagged_temperature; 0 for the others
  std::int32_t centre = 0;                     ///< in the format of the signal
  std::int32_t half_range = 0;                 ///< the same; 0: no input
  int shift = 0;                               ///< half_range * 2^shift is below 2^31
};

/// Words of a hidden neuron in the model table: bias, weights (0 for inputs that the network does
/// not have), weight in the sum of the output.
constexpr std::size_t kNeuronWords = 1 + kMaxNetworkInputs + 1;

/// inputs -> hidden -> one output y; drift = centre + amplitude * y. Without hidden neurons: no
/// network.
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

/// `value` clipped to +-half_range; without a branch, on the board as well.
inline std::int32_t clip(std::int32_t value, std::int32_t half_range) {
  value = value < half_range ? value : half_range;
  return value > -half_range ? value : -half_range;
}

/// An input as the network sees it.
struct ScaledInput {
  std::int32_t value;
  bool is_beyond;  ///< the signal is outside the trained range, at whose end it is held
};

/// Raw value of a signal, scaled as the network expects it.
inline ScaledInput scaled_input(std::int32_t raw, const InputScaling& scaling) {
  const std::int32_t difference = saturating_difference(raw, scaling.centre);
  const std::int32_t held = clip(difference, scaling.half_range);
  return {shift_left(held, scaling.shift), held != difference};
}

/// Drift of a network with hidden neurons. Stateless; the number of instructions depends only on
/// the number of neurons and on whether there are four inputs.
DriftSum network_drift(const NetworkParameters& network, const ScaledInputs& inputs);

/// Whether no sum can leave 64 bits for any inputs: in raw units, sum |weight| + 2 |bias| < 2^32 -
/// 1 for every neuron, the output included.
bool network_fits(const NetworkParameters& network);

}  // namespace fog
