#pragma once

#include <cstdint>

namespace fog::hal {

/// Milliseconds since start-up; wraps after 49.7 days, so only differences mean anything.
std::uint32_t milliseconds();

/// Whether milliseconds() is good to 1 %, as a crystal's is, so that samples can be timed by it;
/// not an internal oscillator's over temperature, nor that of an emulator, whose lines keep no
/// time.
bool clock_is_accurate();

/// Whether milliseconds() pass as they should, within 10 %: with any oscillator, not in an
/// emulator.
bool clock_keeps_time();

/// Where the clock is an internal oscillator's, off by up to 8 % in heat and cold, and what comes
/// in on a line makes no sense: takes the next of a few speeds around the nominal one.
void try_another_speed();

/// Waits for the next interrupt (a received byte, the millisecond tick) where the processor can.
void wait_for_event();

}  // namespace fog::hal
