#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fogcomp::board {

/// A connection to a board's output port: a serial device, a pseudo-terminal, or the socket of an
/// emulator.
class BoardPort {
 public:
  /// Opens `path`; a serial device at 921600 baud, 8N1. Throws InputError.
  explicit BoardPort(const std::string& path);
  ~BoardPort();
  BoardPort(const BoardPort&) = delete;
  BoardPort& operator=(const BoardPort&) = delete;

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
