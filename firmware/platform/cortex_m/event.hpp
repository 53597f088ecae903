#pragma once

namespace fog::platform {

/// Ends the present wait_for_event() of hal/clock.hpp, or the next one. To be called by every
/// interrupt handler that has data for the main loop.
void signal_event();

}  // namespace fog::platform
