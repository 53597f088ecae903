#pragma once

#include <string>

namespace fogcomp::model {

/// Most characters of a gyro's serial number that a board holds.
constexpr std::size_t kMaxSerial = 15;

/// Whether a board holds it: 1 to kMaxSerial characters of ASCII, none of them a space.
inline bool is_serial_number(const std::string& text) {
  if (text.empty() || text.size() > kMaxSerial) return false;
  for (const char character : text) {
    if (character <= ' ' || character > '~') return false;
  }
  return true;
}

}  // namespace fogcomp::model
