#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/output_sample.hpp"

namespace fog {

/// Our own frame, little-endian, 28 bytes: all results for a sample in the pipeline's own formats
/// (SPEC.md, "Compact frame").
///   C3 3C | u16 sequence | i32 compensated | i32 denoised | i32 drift (LSB 2^-10 deg/h)
///   | i32 temperature (LSB 2^-16 degC) | u32 status | u16 denoiser delay in samples | u16 CRC-16
/// The CRC covers bytes 2..25.
constexpr std::size_t kCompactFrameBytes = 28;
using CompactFrame = std::array<std::uint8_t, kCompactFrameBytes>;

/// The CRC of a frame without the flag self_test_failed starts from `image_crc`, so it is right
/// only if that is kIntactImage.
CompactFrame encode_compact_frame(const OutputSample& sample, std::uint16_t denoiser_delay,
                                  std::uint32_t image_crc);

/// Reads 28 bytes. Returns false, and changes nothing, unless sync and CRC are right.
bool decode_compact_frame(const std::uint8_t* bytes, OutputSample& sample,
                          std::uint16_t& denoiser_delay);

}  // namespace fog
