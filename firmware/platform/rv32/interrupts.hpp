#pragma once

namespace fog::platform {

/// The machine timer has come to its compare value.
void on_timer_interrupt();

/// Something outside the processor wants attention: provided by the machine, which knows what.
void on_external_interrupt();

/// From here on external interrupts reach the processor.
void enable_external_interrupts();

/// Ends wait_for_event() of hal/clock.hpp, or the next one if the main loop is not waiting now.
void signal_event();

}  // namespace fog::platform
