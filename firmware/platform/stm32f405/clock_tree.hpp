#pragma once

#include <cstdint>

namespace fog::platform {

struct ClockTree {
  std::uint32_t core_hz;
  std::uint32_t apb1_hz;
  std::uint32_t apb2_hz;
  const char* source;
  bool is_fallback;     ///< not the crystal at full speed
  bool has_full_speed;  ///< 144 MHz, from whatever
};

/// Brings the core to 144 MHz, whatever it runs from now: from the crystal (or what drives its pin)
/// if it starts and `try_crystal`, else from the internal oscillator. Where the PLL does not lock
/// either, the part is left as after a reset: 16 MHz everywhere. A crystal that dies later traps
/// (clock security system), and the restart comes back without it.
void start_clock_tree(bool try_crystal = true);

/// What is running: every bit rate and the tick derive from here.
const ClockTree& clock_tree();

}  // namespace fog::platform
