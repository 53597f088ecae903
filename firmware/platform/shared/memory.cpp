#include <cstddef>
#include <cstdint>

// The four functions that GCC calls even in freestanding code (structure copies, large
// initialisers). Simple loops, by words if addresses allow, because structures of the drift model
// are copied once per block. Built with -fno-tree-loop-distribute-patterns: otherwise GCC replaces
// each loop by a call to the function that contains it.
namespace {

using Word [[gnu::may_alias]] = std::uint32_t;

bool word_aligned(const void* address) {
  return (reinterpret_cast<std::uintptr_t>(address) & (sizeof(Word) - 1U)) == 0U;
}

}  // namespace

extern "C" {

void* memcpy(void* destination, const void* source, std::size_t size) {
  void* to = destination;
  if (word_aligned(to) && word_aligned(source)) {
    auto* to_word = static_cast<Word*>(to);
    const auto* from_word = static_cast<const Word*>(source);
    for (; size >= sizeof(Word); size -= sizeof(Word)) *to_word++ = *from_word++;
    to = to_word;
    source = from_word;
  }
  auto* to_byte = static_cast<std::uint8_t*>(to);
  const auto* from_byte = static_cast<const std::uint8_t*>(source);
  for (; size > 0; --size) *to_byte++ = *from_byte++;
  return destination;
}

void* memmove(void* destination, const void* source, std::size_t size) {
  auto* to = static_cast<std::uint8_t*>(destination);
  const auto* from = static_cast<const std::uint8_t*>(source);
  if (to < from) return memcpy(destination, source, size);
  for (std::size_t i = size; i > 0; --i) to[i - 1] = from[i - 1];
  return destination;
}

void* memset(void* destination, int value, std::size_t size) {
  const auto byte = static_cast<std::uint8_t>(value);
  auto* to_byte = static_cast<std::uint8_t*>(destination);
  // Up to a word boundary: frames are bytes at any address.
  for (; size > 0 && !word_aligned(to_byte); --size) *to_byte++ = byte;
  void* to = to_byte;
  auto* to_word = static_cast<Word*>(to);
  const Word word = byte * 0x01010101U;
  for (; size >= sizeof(Word); size -= sizeof(Word)) *to_word++ = word;
  to = to_word;
  to_byte = static_cast<std::uint8_t*>(to);
  for (; size > 0; --size) *to_byte++ = byte;
  return destination;
}

int memcmp(const void* left, const void* right, std::size_t size) {
  const auto* a = static_cast<const std::uint8_t*>(left);
  const auto* b = static_cast<const std::uint8_t*>(right);
  for (std::size_t i = 0; i < size; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}
}
