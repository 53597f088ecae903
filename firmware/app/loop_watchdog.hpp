#pragma once

#include <cstddef>

#include "app/pipeline.hpp"
#include "hal/watchdog.hpp"

namespace fog::app {

/// Starts the watchdog for the main loop. A pass may wait for the output line: four samples that
/// came at once, a silence and two health records are 528 bytes, so 576 are reckoned with.
inline void start_loop_watchdog() {
  constexpr std::size_t kHalfPassBytes = 288;
  constexpr std::uint32_t kUsPerMs = 1000;
  hal::start_watchdog(hal::kWatchdogLoopMs + 2 * output_line().us_of(kHalfPassBytes) / kUsPerMs);
}

}  // namespace fog::app
