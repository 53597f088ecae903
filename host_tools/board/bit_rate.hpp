#pragma once

#include <cstdint>

namespace fogcomp::board {

/// Sets a terminal to any bit rate; termios.h has names for some alone. False, with errno, if the
/// device or the system has no such rate.
bool set_bit_rate(int device, std::uint32_t baud);

}  // namespace fogcomp::board
