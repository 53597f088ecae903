// spec/effects.md, "Network": drift = centre + round(amplitude * y), y the output's sum or its
// tanh.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/network/network.hpp"

namespace {

// For a network whose one neuron is 0: y is the output's bias.
fog::DriftSum drift_of_bias(std::int32_t bias, int shift, bool linear) {
  const std::int32_t neuron[fog::kNeuronWords] = {};
  fog::NetworkParameters network;
  network.input_count = 1;
  network.neurons = {neuron, fog::kNeuronWords};
  network.output_shift = shift;
  network.output_bias = bias;
  network.linear_output = linear;
  network.centre = fog::from_integer<fog::NetworkDrift>(5);
  network.amplitude = fog::from_integer<fog::NetworkDrift>(3);
  return fog::network_drift(network, {});
}

double dph(fog::DriftSum drift) {
  return std::ldexp(static_cast<double>(drift.raw()), -20);
}

TEST(NetworkOutput, IsTheSumWhereItIsLinearWithinTwo) {
  for (const int shift : {0, 1, 5, 16}) {
    const std::int32_t one = 1 << (27 - shift);
    const double lsb = 3.0 / one + std::ldexp(1, -20);
    EXPECT_EQ(dph(drift_of_bias(0, shift, true)), 5);
    EXPECT_EQ(dph(drift_of_bias(one, shift, true)), 5 + 3);
    EXPECT_EQ(dph(drift_of_bias(-one, shift, true)), 5 - 3);
    EXPECT_EQ(dph(drift_of_bias(one + one / 2, shift, true)), 5 + 4.5);
    for (const std::int32_t beyond : {2 * one, INT32_MAX}) {
      EXPECT_NEAR(dph(drift_of_bias(beyond, shift, true)), 5 + 6, lsb) << shift;
      EXPECT_NEAR(dph(drift_of_bias(-beyond, shift, true)), 5 - 6, lsb) << shift;
    }
  }
}

// The fourth input has code of its own.
TEST(NetworkOutput, EachOfFourInputs_WeighsTheSame) {
  const auto drift_of = [](std::size_t at, std::size_t count) {
    std::int32_t neuron[fog::kNeuronWords] = {};
    neuron[1 + at] = 1 << 27;
    neuron[fog::kNeuronWords - 1] = 1 << 27;
    fog::NetworkParameters network;
    network.input_count = count;
    network.neurons = {neuron, fog::kNeuronWords};
    network.amplitude = fog::from_integer<fog::NetworkDrift>(1);
    fog::ScaledInputs inputs{};
    inputs[at] = 1 << 30;
    return fog::network_drift(network, inputs);
  };
  EXPECT_GT(drift_of(0, 3).raw(), 0);
  for (std::size_t at = 0; at < 4; ++at) EXPECT_EQ(drift_of(at, 4), drift_of(0, 3)) << at;
}

TEST(NetworkOutput, IsTanhOfHalfTheSumWhereItIsNot) {
  for (const int shift : {0, 1, 5, 16}) {
    const std::int32_t one = 1 << (27 - shift);
    for (const int sixteenths : {-40, -16, -1, 0, 1, 7, 16, 100}) {
      const double sum = sixteenths / 16.0;
      EXPECT_NEAR(dph(drift_of_bias(one / 16 * sixteenths, shift, false)),
                  5 + 3 * std::tanh(sum / 2), 3e-6)
          << shift << " " << sum;
    }
  }
}

}  // namespace
