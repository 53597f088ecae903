#pragma once

#include <cstdint>

namespace fog::platform {

struct ClockTree {
  std::uint32_t core_hz;
  std::uint32_t apb1_hz;
  std::uint32_t apb2_hz;
  const char* source;
  bool is_fallback;     ///< not the crystal at full speed
  bool has_full_speed;  ///< 168 MHz, from whatever
};

/// Brings the core to 168 MHz, from the crystal if it starts, else from the internal oscillator.
/// Where the PLL does not lock either, the part stays as reset left it: 16 MHz everywhere. A
/// crystal that dies later traps (clock security system), and the restart comes back without it.
void start_clock_tree();

/// What is running: every bit rate and the tick derive from here.
const ClockTree& clock_tree();

}  // namespace fog::platform
