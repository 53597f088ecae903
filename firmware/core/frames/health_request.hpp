#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// What a user sends to the output port to be told something: A5 99, what is asked for (0: the
/// health record, 1: of a board whose model is loaded, what its slots hold), 0, and the CRC-16 of
/// the second to the fourth byte.
constexpr std::size_t kHealthRequestBytes = 6;
using HealthRequest = std::array<std::uint8_t, kHealthRequestBytes>;
inline constexpr HealthRequest kHealthRequest{0xA5, 0x99, 0x00, 0x00, 0x34, 0x2A};
inline constexpr HealthRequest kSlotsRequest{0xA5, 0x99, 0x01, 0x00, 0x05, 0x19};

/// Finds requests of one kind in what comes in.
template <const HealthRequest& kRequest>
class RequestParser {
 public:
  /// Whether this byte completes a request. After anything else than the next byte of one, a first
  /// byte begins anew: no part of a request looks like its start.
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
