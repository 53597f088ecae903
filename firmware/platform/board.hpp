#pragma once

#include <cstdint>

#include "core/frames/serial_line.hpp"

namespace fog::platform {

/// Description of the board for the boot message.
struct BoardDescription {
  const char* name;
  std::uint32_t core_clock_hz;
  const char* clock_source;
  bool clock_is_fallback;         ///< not the intended clock source or speed
  bool restarts_when_power_dips;  ///< the brown-out reset is enabled, as far as known
};

/// Starts clocks, console and the millisecond tick; afterwards everything in hal/ works but the
/// streams and requests. Call once; before it only the watchdog may be started.
void start_board();

/// Opens the lines of the sensor stream, and of the output stream and requests. Requires
/// start_board(); call once.
void open_lines(SerialLine sensor, SerialLine output);

/// Requires start_board().
BoardDescription describe_board();

/// Restarts from the reset vector after the self-test found damage; the reset cause tells it from a
/// power-on.
[[noreturn]] void restart_board();

/// Restarts on request; the reset cause is `software`.
[[noreturn]] void restart_on_request();

}  // namespace fog::platform

namespace fog::app {

/// The application, one per image. Start-up calls it once, with memory initialised.
[[noreturn]] void run();

}  // namespace fog::app
