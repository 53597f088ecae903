#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog::platform {

/// One or two lines of console text, built without a library; excess text is cut off.
class TextLine {
 public:
  TextLine& text(const char* characters) {
    while (*characters != '\0') append(*characters++);
    return *this;
  }

  TextLine& decimal(std::uint32_t value) {
    std::array<char, 10> digits;
    std::size_t count = 0;
    do {
      digits[count++] = static_cast<char>('0' + value % 10U);
      value /= 10U;
    } while (value != 0);
    while (count > 0) append(digits[--count]);
    return *this;
  }

  TextLine& hex(std::uint32_t value) {
    text("0x");
    for (std::uint32_t shift = 32; shift > 0; shift -= 4) {
      append("0123456789abcdef"[(value >> (shift - 4)) & 0xFU]);
    }
    return *this;
  }

  const char* c_str() {
    characters_[length_] = '\0';
    return characters_.data();
  }

 private:
  void append(char character) {
    if (length_ + 1 < characters_.size()) characters_[length_++] = character;
  }

  std::array<char, 152> characters_;  // valid up to length_
  std::size_t length_ = 0;
};

}  // namespace fog::platform
