#pragma once

#include <cstdint>

namespace fog::hal {

/// Milliseconds since start-up; wraps after 49.7 days, so only differences mean anything.
std::uint32_t milliseconds();

/// Waits for the next interrupt (a received byte, the millisecond tick) where the processor can.
void wait_for_event();

}  // namespace fog::hal
