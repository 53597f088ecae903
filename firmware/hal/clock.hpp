#pragma once

#include <cstdint>

namespace fog::hal {

/// Milliseconds since start-up. Wraps after 49.7 days: use only differences.
std::uint32_t milliseconds();

/// Whether milliseconds() is within 1 %, good enough to time samples: true with a crystal; false
/// with an internal oscillator over temperature, and in an emulator, whose serial lines have no
/// timing.
bool clock_is_accurate();

/// Whether milliseconds() is within 10 %: true with any oscillator, false in an emulator.
bool clock_keeps_time();

/// For an internal oscillator, which is off by up to 8 % at extreme temperatures, when the received
/// bytes make no sense: selects the next of a few speeds around the nominal one.
void try_another_speed();

/// Waits for the next interrupt (a received byte, the millisecond tick) if the processor can.
void wait_for_event();

}  // namespace fog::hal
