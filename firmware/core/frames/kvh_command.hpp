#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/status.hpp"

namespace fog {

/// Settings that a board reports to the KVH query commands.
struct KvhSettings {
  std::uint32_t sample_rate_hz = 0;
  bool delta_angle = false;
  std::uint32_t baud = 0;  ///< of the output line
};

/// The commands that drivers of KVH gyros send at start-up (SPEC.md, "KVH commands"): lines of
/// ASCII, terminated by CR or LF. They cannot change what the header has selected: another value is
/// refused.
class KvhCommands {
 public:
  explicit KvhCommands(const KvhSettings& settings) : settings_(settings) {}

  /// Takes a byte. If it completes a line that has an answer, writes the answer to `out` (at least
  /// kMaxAnswer bytes) and returns its size; else returns 0. `status` is what the built-in tests
  /// have found.
  std::size_t feed(std::uint8_t byte, std::uint8_t* out, Status status);

  /// Whether the user has entered the configuration mode, in which no frames are sent.
  bool configuring() const { return configuring_; }
  void leave_configuration() { configuring_ = false; }

  static constexpr std::size_t kMaxLine = 24;
  static constexpr std::size_t kMaxAnswer = kMaxLine + 16;

 private:
  std::size_t answer(std::uint8_t* out, Status status);
  std::size_t answer_setting(std::uint8_t* out) const;

  KvhSettings settings_;
  bool configuring_ = false;
  std::size_t size_ = 0;  // of line_; 0: not within a command; kMaxLine: too long for any command
  std::array<char, kMaxLine> line_{};
};

}  // namespace fog
