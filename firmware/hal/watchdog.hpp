#pragma once

#include <cstdint>

namespace fog::hal {

/// Timeout during start-up, which takes longer than a pass of the main loop: clocks, test of all
/// memory, boot message.
constexpr std::uint32_t kWatchdogStartMs = 500;
/// In the main loop; more by the time that a pass may take on the output line.
constexpr std::uint32_t kWatchdogLoopMs = 100;

/// Starts the watchdog: unless kicked within `timeout_ms` (1 to 2000), the board restarts. It
/// cannot be stopped; another call changes the timeout. May be called before start_board().
void start_watchdog(std::uint32_t timeout_ms);

/// The same for operations longer than a start: 500 to 20,000 ms. Valid until start_watchdog().
void extend_watchdog(std::uint32_t timeout_ms);

/// To be called when the main loop has made progress.
void kick_watchdog();

}  // namespace fog::hal
