#pragma once

#include <cstdint>

namespace fog::hal {

// A clock that goes on while the board is held in reset, in images that are built with one
// (FOG_RESET_CLOCK); else nothing of this exists.

/// Differences of less than a day are good to 4 ms and 100 ppm; none is shorter than what passed.
struct LastingTime {
  bool known;        ///< the clock runs, and has not been set since it started
  std::uint64_t ms;  ///< since an arbitrary time
};

/// What the clock says. Never waits: starts the clock where it does not run, and says that it is
/// unknown until it does, some calls and seconds later. Wants to be called once a block, after the
/// board has been started: two calls within 0.1 ms may find it unknown.
LastingTime lasting_time();

}  // namespace fog::hal
