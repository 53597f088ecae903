#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/bytes/crc.hpp"

namespace fog {

/// Words in memory that start-up leaves alone. After a reset that memory holds what was there, or
/// anything, so the words count only with their own CRC, and only for their owner: a number that
/// nobody else has.
template <std::size_t kCapacity>
class KeptWords {
 public:
  static constexpr std::size_t capacity = kCapacity;

  std::uint32_t* words() { return words_.data(); }
  /// That the first `size` of the words are written; 0: that there are none.
  void seal(std::size_t size, std::uint32_t owner) {
    size_ = static_cast<std::uint32_t>(size);
    crc_ = crc(owner);
  }
  void forget() { size_ = 0; }
  /// How many are written; only where they are intact.
  std::size_t size() const { return size_; }
  /// Whether there are any, as they were sealed.
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
