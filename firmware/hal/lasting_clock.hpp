#pragma once

#include <cstdint>

namespace fog::hal {

// A clock that runs while the board is held in reset, only in images built with one
// (FOG_RESET_CLOCK).

/// Differences of less than a day are good to 4 ms and 100 ppm, and never shorter than the true
/// time.
struct LastingTime {
  bool known;        ///< the clock runs and was not set since then
  std::uint64_t ms;  ///< since an arbitrary time
};

/// Reads the clock. Never waits: starts the clock if it does not run, and returns unknown until it
/// does, some calls and seconds later. To be called once per block, after start_board(): of two
/// calls within 0.1 ms the second may return unknown.
LastingTime lasting_time();

}  // namespace fog::hal
