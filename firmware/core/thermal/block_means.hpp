#pragma once

#include <array>

#include "core/signal/inputs.hpp"

namespace fog {

/// Means of one block over its good samples; not clamped, not filtered. Inputs that the model does
/// not need stay 0.
template <class N>
struct BlockMeans {
  typename N::Temperature temperature{};  ///< coil sensor
  typename N::Rate input_rate{};          ///< about the axis
  typename N::Elapsed elapsed{};          ///< blocks from power-on to the end of this one
  std::array<typename N::template Number<16>, kExtensionInputs> extension{};
  /// How the input rate changes within the block: on the host alone, only a recording tells it.
  [[no_unique_address]] typename N::RateWithin rate_within{};
  /// The last power-on: on the host alone, a recording may go on after it.
  [[no_unique_address]] typename N::PowerOn power_on{};

  typename N::Elapsed since_power_on() const { return N::since(power_on, elapsed); }

  /// Value of an extension input, in its unit.
  typename N::template Number<16> operator[](Input input) const {
    return extension[extension_number(input)];
  }
  typename N::template Number<16>& operator[](Input input) {
    return extension[extension_number(input)];
  }
};

}  // namespace fog
