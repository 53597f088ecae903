#pragma once

#include <cstddef>
#include <cstdint>

namespace fog {

/// A view of `size` consecutive values that somebody else owns.
template <typename T>
struct Span {
  T* data = nullptr;
  std::size_t size = 0;

  constexpr T& operator[](std::size_t index) const { return data[index]; }
  constexpr T* begin() const { return data; }
  constexpr T* end() const { return data + size; }
};

}  // namespace fog
