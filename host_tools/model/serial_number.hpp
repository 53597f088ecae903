#pragma once

#include <string>

namespace fogcomp::model {

/// Largest length of a gyro's serial number on a board.
constexpr std::size_t kMaxSerial = 15;

/// Whether `text` is valid: 1 to kMaxSerial ASCII characters without spaces.
inline bool is_serial_number(const std::string& text) {
  if (text.empty() || text.size() > kMaxSerial) return false;
  for (const char character : text) {
    if (character <= ' ' || character > '~') return false;
  }
  return true;
}

}  // namespace fogcomp::model
