#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/inputs.hpp"

namespace fog {

/// Possible inputs of a network; their numbers in the model table. In the order of Input, but for
/// number 2.
enum class NetworkInput : std::int32_t {
  temperature = 0,
  temperature_rate = 1,
  lagged_temperature = 2,  ///< degC, the temperature through a first-order lag
  elapsed = 3,
  input_rate = 4,
};
constexpr std::size_t kNetworkInputs = kInputs + 1;

constexpr NetworkInput network_input(Input input) {
  const auto number = static_cast<std::int32_t>(input);
  return static_cast<NetworkInput>(input < Input::elapsed ? number : number + 1);
}
/// The signal that the input is derived from.
constexpr Input input_of(NetworkInput input) {
  if (input == NetworkInput::lagged_temperature) return Input::temperature;
  const auto number = static_cast<std::int32_t>(input);
  return static_cast<Input>(input < NetworkInput::lagged_temperature ? number : number - 1);
}

/// Largest number of inputs of a network.
constexpr std::size_t kMaxNetworkInputs = 4;

using NetworkInputMask = std::uint32_t;  ///< bit = NetworkInput; 0: no network
constexpr NetworkInputMask kAllNetworkInputs = (NetworkInputMask{1} << kNetworkInputs) - 1U;
constexpr NetworkInputMask bit_of(NetworkInput input) {
  return NetworkInputMask{1} << static_cast<unsigned>(input);
}

/// Inputs that a network with this mask uses beside the temperature, which is always available.
constexpr InputMask inputs_of_network(NetworkInputMask mask) {
  constexpr NetworkInputMask kBefore = bit_of(NetworkInput::lagged_temperature) - 1U;
  return (mask & kBefore) | (mask / 2U & ~kBefore);
}

}  // namespace fog
