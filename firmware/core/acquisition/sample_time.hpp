#pragma once

#include <cstdint>

namespace fog {

/// When a sample came, by a clock of the board's own that is good to 1 %; unknown where there is
/// none, or where samples do not come when they were measured, as in a replay.
struct SampleTime {
  bool known = false;
  std::uint32_t ms = 0;  ///< wraps: only differences mean anything
};

/// What a pipeline is given that has no clock.
struct NoClock {
  SampleTime operator()() const { return {}; }
};

}  // namespace fog
