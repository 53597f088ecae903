#pragma once

namespace fog::platform {

/// Ends wait_for_event() of hal/clock.hpp, or the next one if the main loop is not waiting now:
/// what every interrupt handler does that has something for the main loop.
void signal_event();

}  // namespace fog::platform
