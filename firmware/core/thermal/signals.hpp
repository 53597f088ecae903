#pragma once

#include "core/signal/quantities.hpp"
#include "core/thermal/block_means.hpp"

namespace fog {

/// Signals of one block that every effect and the network can use.
template <class N>
struct Signals {
  typename N::Temperature temperature{};  ///< coil sensor, block mean, in the trained range
  typename N::TemperatureRate temperature_rate{};  ///< its filtered derivative
  BlockMeans<N> block{};                           ///< as measured
};

/// Calls `use` with the value of an input of kPossible; other inputs have no code.
template <InputMask kPossible, class N, class Use>
constexpr auto use_value(const Signals<N>& signals, Input input, Use use) {
  const auto is = [input](Input other) { return has(kPossible, other) && input == other; };
  if (is(Input::temperature_rate)) return use(signals.temperature_rate);
  if (is(Input::elapsed)) return use(signals.block.since_power_on());
  if (is(Input::input_rate)) return use(signals.block.input_rate);
  if constexpr ((kPossible & kAllExtensionInputs) != 0U) {
    if (is_extension(input)) return use(signals.block[input]);
  }
  return use(signals.temperature);
}

/// Raw value, in the format of the input.
template <InputMask kPossible>
constexpr std::int32_t raw_value(const Signals<BoardNumbers>& signals, Input input) {
  return use_value<kPossible>(signals, input, [](auto value) { return value.raw(); });
}

}  // namespace fog
