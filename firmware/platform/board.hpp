#pragma once

#include <cstdint>

namespace fog::platform {

/// What the boot message says of the board.
struct BoardDescription {
  const char* name;
  std::uint32_t core_clock_hz;
  const char* clock_source;
  bool clock_is_fallback;  ///< neither the clock nor the speed that the board is meant to have
  bool restarts_when_power_dips;  ///< the brown-out reset is on, so far as the board can tell
};

/// Clocks, ports and the millisecond tick: after it everything in hal/ works. Called once; before
/// it only the watchdog may be started.
void start_board();

/// Valid after start_board().
BoardDescription describe_board();

/// Because the self-test found damage: restarts from the reset vector, as after power-on but for
/// the reset cause.
[[noreturn]] void restart_board();

/// The same because somebody wants it: the reset cause is `software`.
[[noreturn]] void restart_on_request();

}  // namespace fog::platform

namespace fog::app {

/// The application: provided by each image, entered once by start-up with memory initialised.
[[noreturn]] void run();

}  // namespace fog::app
