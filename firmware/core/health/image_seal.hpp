#pragma once

#include <array>
#include <cstdint>

#include "core/bytes/crc.hpp"

namespace fog {

/// The last word of an image is its seal: chosen after linking so that the CRC-32 over the whole
/// image, begun with kImageCrcStart, ends in kIntactImage (SPEC.md, "Seal of the image"). That is
/// what the CRC of an output frame begins with, so that frames can go on from the image's CRC
/// without anybody comparing it. The start is another value: a check that is never run must not
/// look like one that succeeded.
constexpr std::uint32_t kImageCrcStart = 0;
constexpr std::uint32_t kIntactImage = kCrc32Initial;

/// The seal of what came to `crc`: with these four bytes behind it, it comes to kIntactImage.
constexpr std::array<std::uint8_t, 4> seal_of(std::uint32_t crc) {
  constexpr std::uint32_t kEndsInOnes = 0x46AF6449U;  // as a CRC, followed by four bytes of 0
  const std::uint32_t seal = crc ^ kEndsInOnes;
  return {static_cast<std::uint8_t>(seal >> 24U), static_cast<std::uint8_t>(seal >> 16U),
          static_cast<std::uint8_t>(seal >> 8U), static_cast<std::uint8_t>(seal)};
}

}  // namespace fog
