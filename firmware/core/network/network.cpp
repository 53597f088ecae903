#include "core/network/network.hpp"

namespace fog {
namespace {

constexpr auto kOne = from_integer<ActivationOutput>(1);

ActivationOutput activate(Activation activation, ActivationInput x) {
  switch (activation) {
    case Activation::logsig:
      return logistic(x);
    case Activation::tansig:
      return hyperbolic_tangent(x);
    case Activation::linear:
      break;
  }
  return saturate_to<ActivationOutput>(x);
}

// One neuron. Inputs are within +-1, so the sum fits (layer_fits) and the bias, which has the
// weights' format, is added as a weight of the input 1.
ActivationOutput neuron(const LayerParameters& layer, std::size_t row, const std::int32_t* inputs,
                        std::size_t input_count) {
  const std::int32_t* weights = layer.weights.data + row * input_count;
  std::int64_t sum = std::int64_t{layer.biases[row]} * kOne.raw();
  for (std::size_t i = 0; i < input_count; ++i) sum += std::int64_t{weights[i]} * inputs[i];
  const int dropped =
      layer.fraction + ActivationOutput::fractional_bits - ActivationInput::fractional_bits;
  return activate(layer.activation,
                  ActivationInput::from_raw(saturate<std::int32_t>(round_shift(sum, dropped))));
}

}  // namespace

// The difference is clipped at the format of the signals, which are far inside it; the product is
// below 2^62.
ActivationOutput normalised(std::int32_t raw, const InputScaling& scaling) {
  const auto difference = saturate<std::int32_t>(std::int64_t{raw} - scaling.centre);
  const std::int64_t scaled =
      round_shift(std::int64_t{difference} * scaling.multiplier, scaling.shift);
  return clamp(ActivationOutput::from_raw(saturate<std::int32_t>(scaled)), -kOne, kOne);
}

DriftSum network_drift(const NetworkParameters& network, int coefficient_fraction,
                       const std::int32_t* inputs) {
  std::array<std::int32_t, kMostHidden> hidden;  // raw, so that nothing is written to it twice
  const std::size_t hidden_count = network.hidden.biases.size;
  for (std::size_t row = 0; row < hidden_count; ++row) {
    hidden[row] = neuron(network.hidden, row, inputs, network.input_count).raw();
  }
  const ActivationOutput y = neuron(network.output, 0, hidden.data(), hidden_count);
  // |y| <= 2 (linear output) and centre, amplitude < 2^31: below 2^63.
  const std::int64_t drift =
      std::int64_t{network.amplitude} * y.raw() + std::int64_t{network.centre} * kOne.raw();
  return DriftSum::from_raw(round_shift(
      drift, coefficient_fraction + ActivationOutput::fractional_bits - DriftSum::fractional_bits));
}

bool layer_fits(const LayerParameters& layer) {
  const std::size_t rows = layer.biases.size;
  if (rows == 0) return layer.weights.size == 0;
  const std::size_t columns = layer.weights.size / rows;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto magnitude = [](std::int32_t raw) {
      return raw < 0 ? -std::int64_t{raw} : std::int64_t{raw};
    };
    std::int64_t sum = magnitude(layer.biases[row]);
    for (std::size_t i = 0; i < columns; ++i) {
      sum += magnitude(layer.weights[row * columns + i]);
    }
    if (sum > (std::int64_t{1} << 31)) return false;
  }
  return true;
}

}  // namespace fog
