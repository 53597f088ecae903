#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/inputs.hpp"

namespace fog {

/// A signal that a network can have as input; its number in the model table. Add at the end.
enum class NetworkInput : std::int32_t {
  temperature = 0,         ///< degC, in the trained range
  temperature_rate = 1,    ///< degC/min
  lagged_temperature = 2,  ///< degC, the temperature through a first-order lag
  elapsed = 3,             ///< time since power-on: blocks on the board, seconds on the host
  input_rate = 4,          ///< deg/h, the block before's
};
constexpr std::size_t kNetworkInputs = 5;

/// As many as one network takes.
constexpr std::size_t kMostNetworkInputs = 4;

using NetworkInputMask = std::uint32_t;  ///< bit = NetworkInput; 0: no network
constexpr NetworkInputMask kAllNetworkInputs = (NetworkInputMask{1} << kNetworkInputs) - 1U;
constexpr NetworkInputMask bit_of(NetworkInput input) {
  return NetworkInputMask{1} << static_cast<unsigned>(input);
}

/// What a network with these inputs needs beside the coil's temperature.
constexpr InputMask needs_of_network(NetworkInputMask mask) {
  return ((mask & bit_of(NetworkInput::elapsed)) != 0U ? bit_of(Input::elapsed) : 0U) |
         ((mask & bit_of(NetworkInput::input_rate)) != 0U ? bit_of(Input::input_rate) : 0U);
}

}  // namespace fog
