#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "flip_plan.hpp"

namespace fogcomp::injection {

using Bytes = std::vector<std::uint8_t>;

/// QEMU has ended, as it does when the processor locks up.
struct QemuEnded : std::runtime_error {
  QemuEnded() : std::runtime_error("QEMU has ended") {}
};

/// A board in a QEMU of its own, whose serial ports and debug port (gdbstub) this program holds.
class EmulatedBoard {
 public:
  /// Loads `elf` on QEMU's `machine`, stopped before the first instruction. Throws
  /// std::runtime_error where QEMU cannot be started.
  EmulatedBoard(const std::string& machine, const std::string& elf);
  ~EmulatedBoard();
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;

  /// Flips a bit of memory, only while stopped. Throws std::runtime_error if the bit does not
  /// change.
  void flip(const Flip& flip);

  void resume();
  void stop();

  void send_to_sensor_port(const Bytes& bytes);
  /// Number of bytes that the sensor port has not taken yet.
  std::size_t unsent() const { return to_sensor_.size(); }

  /// Appends new data to output and console, waiting up to `patience` for the first byte. Returns
  /// whether anything came. Throws QemuEnded.
  bool exchange(std::chrono::milliseconds patience);
  /// How often the console has shown `text`.
  std::size_t times_said(const std::string& text) const;
  /// Number of complete boot messages so far: a restart need not be announced.
  std::size_t boots() const { return times_said("image: "); }  // its last line

  Bytes output;
  std::string console;

 private:
  void start(const std::string& machine, const std::string& elf);
  bool take_output();
  bool exchange_at_sockets();
  int connect_to(const std::string& port);
  std::string command(const std::string& packet);
  std::string receive_packet();
  void send_all(int socket, const std::string& text);
  std::uint8_t read_byte(std::uint32_t address);
  void write_byte(std::uint32_t address, std::uint8_t value);

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
