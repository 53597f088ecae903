#pragma once

#include <cstddef>
#include <cstdint>

namespace fog {

/// A serial line: bit rate, parity and stop bits; always eight data bits. Held as its word of the
/// model table: bit rate + 2^24 * format. Format, bit 0: two stop bits; bits 1, 2: 0 no parity,
/// 1 even, 2 odd.
class SerialLine {
 public:
  constexpr SerialLine() = default;  ///< 921600 8N1
  explicit constexpr SerialLine(std::uint32_t word) : word_(word) {}

  constexpr std::uint32_t word() const { return word_; }
  constexpr std::uint32_t baud() const { return word_ & 0xFF'FFFFU; }
  constexpr bool has_two_stop_bits() const { return (word_ >> kStopBit & 1U) != 0; }
  constexpr bool has_parity() const { return word_ >> kParityBit != 0; }
  constexpr bool has_odd_parity() const { return word_ >> kParityBit == 2; }

  /// Bits that a byte takes, start bit included: 10 to 12.
  constexpr std::uint32_t bits_per_byte() const {
    return 10U + (has_two_stop_bits() ? 1U : 0U) + (has_parity() ? 1U : 0U);
  }

  /// Whether the bit rate is within 9600 to `max_baud` and the format is one of the six.
  constexpr bool is_valid(std::uint32_t max_baud) const {
    return baud() >= kMinBaud && baud() <= max_baud && word_ >> kStopBit < kFormats;
  }

  /// Whether `bytes` (at most 300) pass within `period_us`.
  constexpr bool carries(std::size_t bytes, std::uint32_t period_us) const {
    return std::uint64_t{period_us} * baud() >= scaled_bits(bytes);
  }

  /// Time that `bytes` (at most 300) take, us, rounded up.
  constexpr std::uint32_t us_of(std::size_t bytes) const {
    return (scaled_bits(bytes) - 1U) / baud() + 1U;
  }

  static constexpr std::uint32_t kMinBaud = 9'600;
  static constexpr std::uint32_t kStopBit = 24;
  static constexpr std::uint32_t kParityBit = 25;
  static constexpr std::uint32_t kFormats = 6;

 private:
  // Bits times the microseconds of a second.
  constexpr std::uint32_t scaled_bits(std::size_t bytes) const {
    return static_cast<std::uint32_t>(bytes) * bits_per_byte() * 1'000'000U;
  }

  std::uint32_t word_ = 921'600;
};

/// Fastest lines that a table may choose.
constexpr std::uint32_t kMaxSensorBaud = 2'000'000;
constexpr std::uint32_t kMaxOutputBaud = 4'147'200;

}  // namespace fog
