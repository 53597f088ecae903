#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/frames/serial_line.hpp"

namespace fogcomp::board {

/// Sets a terminal to any bit rate; termios.h has names for some alone. False, with errno, if the
/// device or the system has no such rate.
bool set_bit_rate(int device, std::uint32_t baud);

/// A connection to a board's output port: a serial device, a pseudo-terminal, or the socket of an
/// emulator.
class BoardPort {
 public:
  /// Opens `path`; a serial device is set to `line`. Throws InputError.
  BoardPort(const std::string& path, fog::SerialLine line);
  ~BoardPort();
  BoardPort(const BoardPort&) = delete;
  BoardPort& operator=(const BoardPort&) = delete;

  /// Sets a serial device to another line; nothing else has any. Throws InputError if it cannot.
  void set_line(fog::SerialLine line);

  /// Throws InputError if the bytes cannot be sent within a second.
  void write(const std::uint8_t* bytes, std::size_t size);

  /// Waits up to `patience_ms` for bytes, and reads at most `capacity`; 0 if none came. Throws
  /// InputError if the connection is closed.
  std::size_t read(std::uint8_t* bytes, std::size_t capacity, int patience_ms);

 private:
  std::string path_;
  int descriptor_ = -1;
};

}  // namespace fogcomp::board
