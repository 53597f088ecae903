#pragma once

#include <cstddef>

#include "emulated_board.hpp"

namespace fogcomp::injection {

/// An output stream as seen by a user's driver: accepted frames (header and CRC right), and those
/// with a valid rate. Reads KVH and compact frames.
class OutputReader {
 public:
  /// Continues in `output`, which must only have grown since the last call.
  void read(const Bytes& output);

  std::size_t accepted() const { return accepted_; }
  std::size_t valid() const { return valid_; }
  /// Number of initial frames that may be invalid, as after a start.
  static constexpr std::size_t kStarting = 600;
  /// Whether anything but a frame with a valid rate came, and the number of frames before it.
  bool saw_fault() const { return saw_fault_; }
  std::size_t valid_before_fault() const { return valid_before_fault_; }

 private:
  std::size_t position_ = 0;
  std::size_t accepted_ = 0;
  std::size_t valid_ = 0;
  bool saw_fault_ = false;
  std::size_t valid_before_fault_ = 0;
};

}  // namespace fogcomp::injection
