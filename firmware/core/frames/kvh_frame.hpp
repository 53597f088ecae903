#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// KVH "format A", big-endian: header, X Y Z rotation and X Y Z acceleration as float32, status,
/// sequence 0..127, whole degC, CRC-32. For a one-axis gyro, Z rotation is a rate in rad/s or
/// its angle per sample in rad; the other five are 0 and not valid (SPEC.md, "KVH format
/// A").
constexpr std::size_t kKvhFrameBytes = 36;
using KvhFrame = std::array<std::uint8_t, kKvhFrameBytes>;

/// `rotation`: bits of the float of Z rotation; `valid`: whether it is. `frame_number` counts the
/// frames sent; its lower 7 bits are the frame's sequence. The CRC of a frame that marks Z valid
/// starts from `image_crc`, so it is right only if that is kIntactImage.
KvhFrame encode_kvh_frame(Temperature temperature, std::uint32_t rotation, bool valid,
                          std::uint32_t frame_number, std::uint32_t image_crc);

}  // namespace fog
