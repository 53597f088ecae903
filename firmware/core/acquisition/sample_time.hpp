#pragma once

#include <cstdint>

namespace fog {

/// Arrival time of a sample by the board's clock (within 1 %). Unknown without a clock, and where
/// samples do not arrive in real time (replay).
struct SampleTime {
  bool known = false;
  std::uint32_t ms = 0;  ///< wraps: use only differences
};

/// Clock of a pipeline without a clock.
struct NoClock {
  SampleTime operator()() const { return {}; }
};

}  // namespace fog
