#include <cstddef>
#include <cstdint>

// The four functions that GCC calls even in freestanding code (structure copies, large
// initialisers). Plain byte loops: nothing on the sample path copies more than a frame. Built with
// -fno-tree-loop-distribute-patterns, without which GCC recognises each loop and replaces it by a
// call to the very function it is in.
extern "C" {

void* memcpy(void* destination, const void* source, std::size_t size) {
  auto* to = static_cast<std::uint8_t*>(destination);
  const auto* from = static_cast<const std::uint8_t*>(source);
  for (std::size_t i = 0; i < size; ++i) to[i] = from[i];
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
  auto* to = static_cast<std::uint8_t*>(destination);
  for (std::size_t i = 0; i < size; ++i) to[i] = static_cast<std::uint8_t>(value);
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
