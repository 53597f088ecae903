#pragma once

#include <cstdint>

namespace fog {

// Numbers that share a word, and words that share 64 bits. Only upper_word() rounds.

/// |value|, unsigned, so that it also holds the magnitude of the lowest value.
constexpr std::uint32_t magnitude_of(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return value < 0 ? 0U - bits : bits;
}

/// The lower 16 bits, unsigned.
constexpr std::uint32_t lower_half(std::int32_t word) {
  return static_cast<std::uint16_t>(word);
}

/// One word: the lower 16 bits of `upper` above `lower` (below 2^16).
constexpr std::uint32_t pack_halves(std::uint32_t lower, std::int32_t upper) {
  return (static_cast<std::uint32_t>(upper) << 16U) | lower;
}

/// Start value of a sum of products whose result is its upper word: upper * 2^32 plus half an LSB
/// of the upper word, so that upper_word() of the sum rounds to nearest, halves upwards.
constexpr std::int64_t sum_of_upper_word(std::int32_t upper) {
  const auto bits = static_cast<std::uint32_t>(upper);
  return static_cast<std::int64_t>((std::uint64_t{bits} << 32U) | (std::uint64_t{1} << 31U));
}

/// sum / 2^32, rounded down; always fits. Shifted as unsigned: after a signed shift GCC takes the
/// result for 64 bits wide and multiplies accordingly.
constexpr std::int32_t upper_word(std::int64_t sum) {
  return static_cast<std::int32_t>(static_cast<std::uint64_t>(sum) >> 32U);
}

/// Two words that a function returns in two registers; a struct would be returned in memory.
class RegisterPair {
 public:
  static constexpr std::uint64_t of(std::int32_t first, std::int32_t second) {
    return (std::uint64_t{static_cast<std::uint32_t>(second)} << 32U) |
           static_cast<std::uint32_t>(first);
  }
  constexpr explicit RegisterPair(std::uint64_t both) : both_(both) {}
  constexpr std::int32_t first() const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(both_));
  }
  constexpr std::int32_t second() const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(both_ >> 32U));
  }

 private:
  std::uint64_t both_;
};

}  // namespace fog
