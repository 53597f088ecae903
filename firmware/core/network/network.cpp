#include "core/network/network.hpp"

#include "core/fixed_point/saturating_difference.hpp"

namespace fog {
namespace {

// A sum of products of raw weights and inputs, of which the upper half counts. The lower one begins
// with half of the upper one's LSB, so that the upper one is rounded.
std::int64_t sum_from(std::int32_t bias) {
  const auto upper = static_cast<std::uint32_t>(bias);
  return static_cast<std::int64_t>((std::uint64_t{upper} << 32U) | (std::uint64_t{1} << 31U));
}

std::int64_t product(std::int32_t weight, std::int32_t input) {
  return std::int64_t{weight} * input;
}

std::int32_t upper_half(std::int64_t sum) {
  return static_cast<std::int32_t>(floor_shift(sum, 32));
}

// By what a layer's sums come to the format of ActivationInput, and where they are clipped for
// that.
struct Scale {
  explicit Scale(int layer_shift)
      : shift(static_cast<unsigned>(layer_shift)), most(std::uint32_t{INT32_MAX} >> shift) {}

  unsigned shift;
  std::uint32_t most;
};

[[gnu::always_inline]] inline ActivationOutput activate(std::int64_t sum, Scale scale) {
  const std::int32_t upper = upper_half(sum);
  const auto sign = static_cast<std::uint32_t>(floor_shift(upper, 31));  // all bits or none
  std::uint32_t magnitude = (static_cast<std::uint32_t>(upper) ^ sign) - sign;
  magnitude = magnitude < scale.most ? magnitude : scale.most;
  return symmetric_logistic(magnitude << scale.shift, sign);
}

ActivationOutput linear(std::int64_t sum, int layer_shift) {
  const int shift =
      layer_shift + ActivationOutput::fractional_bits - ActivationInput::fractional_bits;
  const std::int32_t most = floor_shift(INT32_MAX, shift);
  return ActivationOutput::from_raw(shift_left(clamp(upper_half(sum), -most, most), shift));
}

// In raw.
bool sum_fits(std::uint64_t weights, std::int32_t bias) {
  const std::int64_t raw = bias;
  return weights + 2 * static_cast<std::uint64_t>(raw < 0 ? -raw : raw) < UINT32_MAX;
}

std::uint32_t magnitude(std::int32_t weight) {
  const auto bits = static_cast<std::uint32_t>(weight);
  return weight < 0 ? 0U - bits : bits;
}

}  // namespace

std::int32_t scaled_input(std::int32_t raw, const InputScaling& scaling) {
  std::int32_t difference = saturating_difference(raw, scaling.centre);
  difference = difference < scaling.reach ? difference : scaling.reach;
  difference = difference > -scaling.reach ? difference : -scaling.reach;
  return shift_left(difference, scaling.shift);
}

DriftSum network_drift(const NetworkParameters& network, const ScaledInputs& inputs) {
  std::int64_t output = sum_from(network.output_bias);
  const std::int32_t* const in = inputs.data();
  const std::int32_t* const end = network.neurons.end();
  const Scale hidden(network.hidden_shift);
  for (const std::int32_t* word = network.neurons.begin(); word != end; word += kNeuronWords) {
    std::int64_t sum = sum_from(word[0]);
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kMostNetworkInputs; ++i) sum += product(word[1 + i], in[i]);
    output += product(word[1 + kMostNetworkInputs], activate(sum, hidden).raw());
  }
  const ActivationOutput y = network.linear_output ? linear(output, network.output_shift)
                                                   : activate(output, Scale(network.output_shift));
  return round_to<DriftSum>(network.amplitude * y) + round_to<DriftSum>(network.centre);
}

bool network_fits(const NetworkParameters& network) {
  bool fits = true;
  std::uint64_t output_weights = 0;
  for (const std::int32_t* word = network.neurons.begin(); word != network.neurons.end();
       word += kNeuronWords) {
    std::uint64_t weights = 0;
    for (std::size_t i = 1; i <= kMostNetworkInputs; ++i) weights += magnitude(word[i]);
    fits = fits && sum_fits(weights, word[0]);
    output_weights += magnitude(word[kNeuronWords - 1]);
  }
  return fits && sum_fits(output_weights, network.output_bias);
}

}  // namespace fog
