#pragma once

#include <array>
#include <cstdint>

#include "core/bytes/crc.hpp"

namespace fog {

/// The last word of an image is its seal. It is chosen after linking so that the CRC-32 over the
/// whole image, started with kImageCrcStart, is kIntactImage (SPEC.md, "Seal of the image"). That
/// is also the start value of the CRC of an output frame, so that frames can continue the image's
/// CRC without a comparison. The start value differs from it: a check that is never run must not
/// look like one that succeeded.
constexpr std::uint32_t kImageCrcStart = 0;
constexpr std::uint32_t kIntactImage = kCrc32Initial;

/// Seal of data with the CRC `crc`: followed by these four bytes, its CRC is kIntactImage.
constexpr std::array<std::uint8_t, 4> seal_of(std::uint32_t crc) {
  constexpr std::uint32_t kEndsInOnes = 0x46AF6449U;  // CRC that four bytes of 0 turn into all ones
  const std::uint32_t seal = crc ^ kEndsInOnes;
  return {static_cast<std::uint8_t>(seal >> 24U), static_cast<std::uint8_t>(seal >> 16U),
          static_cast<std::uint8_t>(seal >> 8U), static_cast<std::uint8_t>(seal)};
}

}  // namespace fog
