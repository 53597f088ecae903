#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fogcomp::injection {

using Bytes = std::vector<std::uint8_t>;

/// A board in QEMU whose serial ports and debug port (gdbstub) this program holds. It can be
/// stopped, its memory changed, and started again from reset, hundreds of times in one process.
class EmulatedBoard {
 public:
  /// Boots `elf` on QEMU's `machine`, stopped before the first instruction. Throws
  /// std::runtime_error where QEMU cannot be started.
  EmulatedBoard(std::string machine, std::string elf);
  ~EmulatedBoard();
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;

  /// Whether QEMU has ended: it does where the processor locks up. Everything else then throws
  /// std::runtime_error.
  bool ended();
  /// A new QEMU with the image as it is in the file.
  void replace();

  // Only while stopped; after them it still is.
  std::uint8_t read_byte(std::uint32_t address);
  void write_byte(std::uint32_t address, std::uint8_t value);
  void reset();

  void resume();
  void stop();

  void send_to_sensor_port(const Bytes& bytes);
  /// Bytes that the sensor port has not taken yet.
  std::size_t unsent() const { return to_sensor_.size(); }

  /// Moves what has come out since to the ends of output and console, waiting up to `patience` for
  /// the first of it. Returns whether anything came.
  bool exchange(std::chrono::milliseconds patience);
  /// Forgets everything that is under way.
  void drain();

  Bytes output;
  std::string console;

 private:
  void start();
  void end();
  int connect_to(const std::string& port);
  std::string command(const std::string& packet);
  std::string receive_packet();
  void send_all(int socket, const std::string& text);

  std::string machine_;
  std::string elf_;
  std::string folder_;
  pid_t process_ = -1;
  int output_port_ = -1;
  int sensor_port_ = -1;
  int console_port_ = -1;
  int debug_port_ = -1;
  Bytes to_sensor_;
  std::string debug_input_;
};

}  // namespace fogcomp::injection
