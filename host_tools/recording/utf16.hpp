#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fogcomp::recording {

enum class ByteOrder : std::uint8_t { little, big };

/// Byte order, if a file that begins with `head` is UTF-16 text ("Unicode text" of a spreadsheet),
/// with or without a byte order mark: nearly all of its first characters are Latin.
std::optional<ByteOrder> utf16_order(std::string_view head);

/// Converts UTF-16 to UTF-8 piece by piece. The byte order mark is dropped; invalid units become
/// U+FFFD.
class Utf16Decoder {
 public:
  explicit Utf16Decoder(ByteOrder order) : order_(order) {}

  /// Largest number of UTF-8 bytes for `bytes` of input and the rest of the previous piece.
  static constexpr std::size_t max_output(std::size_t bytes) { return bytes / 2 * 3 + 8; }
  /// Writes the characters of a piece to `out`, at least max_output(bytes.size()) bytes, and
  /// returns the new end.
  char* decode(std::string_view bytes, char* out);

 private:
  char* take(std::uint32_t unit, char* out);

  ByteOrder order_;
  std::optional<unsigned char> first_byte_;  // of a unit that the next piece completes
  std::uint32_t high_surrogate_ = 0;         // waits for its low surrogate; 0: none
};

}  // namespace fogcomp::recording
