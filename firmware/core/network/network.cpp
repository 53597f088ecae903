#include "core/network/network.hpp"

#include "core/fixed_point/words.hpp"

namespace fog {
namespace {

std::int64_t product(std::int32_t weight, std::int32_t input) {
  return std::int64_t{weight} * input;
}

// Factor that turns the upper word of a layer's sum into a NodePlace. A product instead of a shift:
// node and distance come out in two registers.
std::int32_t places_per_sum(int layer_shift) {
  return power_of_two<std::int32_t>(NodePlace::fractional_bits - ActivationInput::fractional_bits +
                                    layer_shift);
}

[[gnu::always_inline]] inline ActivationOutput activate(std::int64_t sum, std::int32_t places) {
  return symmetric_logistic(NodePlace::from_raw(product(upper_word(sum), places)));
}

ActivationOutput linear(std::int64_t sum, int layer_shift) {
  const int shift =
      layer_shift + ActivationOutput::fractional_bits - ActivationInput::fractional_bits;
  const std::int32_t max = floor_shift(INT32_MAX, shift);
  return ActivationOutput::from_raw(shift_left(clip(upper_word(sum), max), shift));
}

// Largest sum of the magnitudes of a neuron's weights and, twice, its bias, in raw units. A sum
// begins with bias * 2^32 + 2^31; inputs and activations are within 2^31.
constexpr std::uint64_t kMaxWeightSum = UINT32_MAX - 1;
static_assert(kMaxWeightSum <=
              floor_shift(std::uint64_t{INT64_MAX} - power_of_two<std::uint64_t>(31), 31));
// activate(): the upper word times places_per_sum(), which is an int32.
static_assert(NodePlace::fractional_bits - ActivationInput::fractional_bits + kMaxWeightShift < 31);

bool sum_fits(std::uint64_t weights, std::int32_t bias) {
  return weights + 2 * std::uint64_t{magnitude_of(bias)} <= kMaxWeightSum;
}

// Sum of the output neuron. Weights are read in pairs and in this order, one instruction each;
// compiler options preserve it (core/CMakeLists.txt). A fourth input would cost networks without it
// a tenth of their time, because registers run out; hence the template.
template <std::size_t kInputs>
std::int64_t output_sum(const NetworkParameters& network, const ScaledInputs& inputs) {
  static_assert(kMaxNetworkInputs == 4 && kNeuronWords == 6);
  const std::int32_t in[] = {inputs[0], inputs[1], inputs[2], inputs[3]};
  std::int64_t output = sum_of_upper_word(network.output_bias);
  const std::int32_t hidden = places_per_sum(network.hidden_shift);
  const std::int32_t* const end = network.neurons.end();
  for (const std::int32_t* word = network.neurons.begin(); word != end; word += kNeuronWords) {
    const std::int32_t bias = word[0];
    const std::int32_t weight0 = word[1];
    std::int64_t sum = sum_of_upper_word(bias) + product(weight0, in[0]);
    const std::int32_t weight1 = word[2];
    const std::int32_t weight2 = word[3];
    sum += product(weight1, in[1]);
    sum += product(weight2, in[2]);
    if constexpr (kInputs == 4) sum += product(word[4], in[3]);
    const std::int32_t neuron = activate(sum, hidden).raw();
    output += product(word[5], neuron);
  }
  return output;
}

}  // namespace

DriftSum network_drift(const NetworkParameters& network, const ScaledInputs& inputs) {
  const std::int64_t output = network.input_count == kMaxNetworkInputs
                                  ? output_sum<4>(network, inputs)
                                  : output_sum<3>(network, inputs);
  const ActivationOutput y = network.linear_output
                                 ? linear(output, network.output_shift)
                                 : activate(output, places_per_sum(network.output_shift));
  return round_to<DriftSum>(network.amplitude * y) + round_to<DriftSum>(network.centre);
}

bool network_fits(const NetworkParameters& network) {
  bool fits = true;
  std::uint64_t output_weights = 0;
  for (const std::int32_t* word = network.neurons.begin(); word != network.neurons.end();
       word += kNeuronWords) {
    std::uint64_t weights = 0;
    for (std::size_t i = 1; i <= kMaxNetworkInputs; ++i) {
      weights += magnitude_of(word[i]);
      fits = fits && (i <= network.input_count || word[i] == 0);
    }
    fits = fits && sum_fits(weights, word[0]);
    output_weights += magnitude_of(word[kNeuronWords - 1]);
  }
  return fits && sum_fits(output_weights, network.output_bias);
}

}  // namespace fog
