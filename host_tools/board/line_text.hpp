#pragma once

#include <cstdint>
#include <string>

#include "core/frames/serial_line.hpp"

namespace fogcomp::board {

/// "115200,8E1", as given to options: bit rate, and data bits, parity and stop bits unless 8N1.
std::string line_text(fog::SerialLine line);

/// Inverse of line_text(). Throws InputError naming `option` unless the bit rate is within 9600 to
/// `max_baud` and the format is one of 8N1, 8N2, 8E1, 8E2, 8O1, 8O2.
fog::SerialLine parse_line(const std::string& text, std::uint32_t max_baud,
                           const std::string& option);

}  // namespace fogcomp::board
