#pragma once

#include <cstdint>

namespace fog::hal {

/// A board that starts takes longer than its main loop: clocks that do not come up, a test of all
/// memory, a boot message.
constexpr std::uint32_t kWatchdogStartMs = 500;
constexpr std::uint32_t kWatchdogLoopMs = 100;

/// Starts the watchdog: unless kicked within `timeout_ms` (1 to 500), the board restarts. It cannot
/// be stopped again; another call changes the timeout. Works before the board has been started.
void start_watchdog(std::uint32_t timeout_ms);

/// The same for what takes longer than any start: 500 to 20,000 ms. Until start_watchdog().
void extend_watchdog(std::uint32_t timeout_ms);

/// Tells the watchdog that the main loop made progress.
void kick_watchdog();

}  // namespace fog::hal
