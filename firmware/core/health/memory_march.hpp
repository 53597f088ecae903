#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// Patterns for the test of a memory; each is used with its complement. Any two bits of a word
/// differ in at least one pattern.
constexpr std::array<std::uint32_t, 6> kMarchPatterns{0x00000000U, 0x55555555U, 0x33333333U,
                                                      0x0F0F0F0FU, 0x00FF00FFU, 0x0000FFFFU};

/// March C- over `words` words. Finds every cell that is stuck or cannot change, and every cell
/// disturbed by a write to another of these words (for bits of one word: with all kMarchPatterns).
/// Destroys the contents. `Memory` reads and writes words by index; every call is one access.
/// Returns whether all reads gave what was written.
template <class Memory>
bool march(Memory& memory, std::size_t words, std::uint32_t pattern) {
  const std::uint32_t inverse = ~pattern;
  bool good = true;
  const auto exchange = [&](std::size_t i, std::uint32_t expected, std::uint32_t next) {
    good = good && memory.read(i) == expected;
    memory.write(i, next);
  };
  for (std::size_t i = 0; i < words; ++i) memory.write(i, pattern);
  for (std::size_t i = 0; i < words; ++i) exchange(i, pattern, inverse);
  for (std::size_t i = 0; i < words; ++i) exchange(i, inverse, pattern);
  for (std::size_t i = words; i-- > 0;) exchange(i, pattern, inverse);
  for (std::size_t i = words; i-- > 0;) exchange(i, inverse, pattern);
  for (std::size_t i = 0; i < words; ++i) good = good && memory.read(i) == pattern;
  return good;
}

/// The same for a few words, whose contents are restored. Nothing else may access them meanwhile.
template <std::size_t kWords, class Memory>
bool march_and_restore(Memory& memory, std::uint32_t pattern) {
  std::array<std::uint32_t, kWords> held;
  for (std::size_t i = 0; i < kWords; ++i) held[i] = memory.read(i);
  const bool good = march(memory, kWords, pattern);
  for (std::size_t i = 0; i < kWords; ++i) memory.write(i, held[i]);
  return good;
}

}  // namespace fog
