#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// Request that a user sends to the output port: A5 99, the record wanted (0: health record; 1:
/// slots record, from a board with a loaded model), 0, and the CRC-16 of bytes 1 to 3.
constexpr std::size_t kHealthRequestBytes = 6;
using HealthRequest = std::array<std::uint8_t, kHealthRequestBytes>;
inline constexpr HealthRequest kHealthRequest{0xA5, 0x99, 0x00, 0x00, 0x34, 0x2A};
inline constexpr HealthRequest kSlotsRequest{0xA5, 0x99, 0x01, 0x00, 0x05, 0x19};

/// Finds requests of one kind in a byte stream.
template <const HealthRequest& kRequest>
class RequestParser {
 public:
  /// Whether this byte completes a request. An unexpected byte is compared with the start of a new
  /// request; that suffices, because the first byte does not occur later in a request.
  bool feed(std::uint8_t byte) {
    if (byte != kRequest[matched_]) matched_ = 0;
    if (byte != kRequest[matched_]) return false;
    if (++matched_ < kHealthRequestBytes) return false;
    matched_ = 0;
    return true;
  }

 private:
  std::size_t matched_ = 0;
};
using HealthRequestParser = RequestParser<kHealthRequest>;

}  // namespace fog
