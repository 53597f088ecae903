#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fogcomp::recording {

enum class ByteOrder : std::uint8_t { little, big };

/// Whether a file that begins so is UTF-16 text ("Unicode text" of a spreadsheet), with a byte
/// order mark or without: nearly all of its first characters are Latin.
std::optional<ByteOrder> utf16_order(std::string_view head);

/// UTF-16 in, UTF-8 out, in pieces. The byte order mark is left out; what is no character becomes
/// U+FFFD.
class Utf16Decoder {
 public:
  explicit Utf16Decoder(ByteOrder order) : order_(order) {}

  /// Most bytes of UTF-8 that so many bytes make, with what was left of the piece before.
  static constexpr std::size_t max_output(std::size_t bytes) { return bytes / 2 * 3 + 8; }
  /// Writes the characters of a piece to `out`, which has room for max_output(bytes.size()), and
  /// returns its new end.
  char* decode(std::string_view bytes, char* out);

 private:
  char* take(std::uint32_t unit, char* out);

  ByteOrder order_;
  std::optional<unsigned char> first_byte_;  // of a unit that the next piece completes
  std::uint32_t high_surrogate_ = 0;         // that waits for its other half; 0: none
};

}  // namespace fogcomp::recording
