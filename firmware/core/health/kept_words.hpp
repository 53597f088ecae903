#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/bytes/crc.hpp"

namespace fog {

/// Words in memory that start-up does not initialise. After a reset they may hold the old or random
/// values, so they are valid only with their own CRC and for their owner, a unique number.
template <std::size_t kCapacity>
class KeptWords {
 public:
  static constexpr std::size_t capacity = kCapacity;

  std::uint32_t* words() { return words_.data(); }
  /// Marks the first `size` words as written; 0 marks none.
  void seal(std::size_t size, std::uint32_t owner) {
    size_ = static_cast<std::uint32_t>(size);
    crc_ = crc(owner);
  }
  void forget() { size_ = 0; }
  /// Number of words written; valid only if are_intact().
  std::size_t size() const { return size_; }
  /// Whether there are words and they are as sealed by `owner`.
  bool are_intact(std::uint32_t owner) const {
    return size_ - 1U < kCapacity && crc_ == crc(owner);
  }

 private:
  std::uint32_t crc(std::uint32_t owner) const {
    return crc32(reinterpret_cast<const std::uint8_t*>(&size_), (1 + size_) * sizeof size_, owner);
  }

  std::uint32_t crc_;
  std::uint32_t size_;
  std::array<std::uint32_t, kCapacity> words_;
};

}  // namespace fog
