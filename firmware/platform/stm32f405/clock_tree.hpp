#pragma once

#include <array>
#include <cstdint>

namespace fog::platform {

struct ClockTree {
  std::uint32_t core_hz;
  std::array<std::uint32_t, 2> apb_hz;  ///< by Bus
  const char* source;
  bool is_fallback;     ///< not the crystal at full speed
  bool has_full_speed;  ///< 144 MHz, from either source
};

/// Brings the core to 144 MHz from any state: from the crystal (or an external clock at its pin) if
/// `try_crystal` and it starts, else from the internal oscillator. If the PLL does not lock either,
/// the part stays as after a reset: 16 MHz. A crystal that fails later traps (clock security
/// system), and the restart runs without it.
void start_clock_tree(bool try_crystal = true);

/// The running clocks: bit rates and tick derive from them.
const ClockTree& clock_tree();

}  // namespace fog::platform
