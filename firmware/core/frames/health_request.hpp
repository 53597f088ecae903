#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// What a user sends to the output port to be told the board's health: A5 99, what is asked for
/// (0: the health record), 0, and the CRC-16 of the second to the fourth byte.
constexpr std::size_t kHealthRequestBytes = 6;
constexpr std::array<std::uint8_t, kHealthRequestBytes> kHealthRequest{0xA5, 0x99, 0x00,
                                                                       0x00, 0x34, 0x2A};

/// Finds requests in what comes in.
class HealthRequestParser {
 public:
  /// Whether this byte completes a request. After anything else than the next byte of one, a first
  /// byte begins anew: no part of a request looks like its start.
  bool feed(std::uint8_t byte) {
    if (byte != kHealthRequest[matched_]) matched_ = 0;
    if (byte != kHealthRequest[matched_]) return false;
    if (++matched_ < kHealthRequestBytes) return false;
    matched_ = 0;
    return true;
  }

 private:
  std::size_t matched_ = 0;
};

}  // namespace fog
