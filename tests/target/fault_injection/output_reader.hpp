#pragma once

#include <cstddef>

#include "emulated_board.hpp"

namespace fogcomp::injection {

/// What a user's driver makes of an output stream: frames that it would accept (header and CRC
/// right), and of these the ones that mark a rate valid. Reads KVH and compact frames.
class OutputReader {
 public:
  /// Goes on in `output`, which has only grown since the last call.
  void read(const Bytes& output);

  std::size_t accepted() const { return accepted_; }
  std::size_t valid() const { return valid_; }
  /// So many of the first frames may say that their rate is not valid: a board starts so.
  static constexpr std::size_t kStarting = 600;
  /// Whether something came that was no frame with a valid rate, and after how many that were.
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
