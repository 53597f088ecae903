#pragma once

#include "core/thermal/block_means.hpp"

namespace fog {

/// What every effect and the network see, once per block.
template <class N>
struct Signals {
  typename N::Temperature temperature{};  ///< coil sensor, block mean, in the trained range
  typename N::TemperatureRate temperature_rate{};  ///< its filtered derivative
  BlockMeans<N> block{};                           ///< as measured
};

}  // namespace fog
