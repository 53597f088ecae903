#pragma once

namespace fog::hal {

/// Starts the watchdog: unless kicked within 100 ms, the board restarts. It cannot be stopped
/// again.
void start_watchdog();

/// Tells the watchdog that the main loop made progress.
void kick_watchdog();

}  // namespace fog::hal
