#pragma once

#include <cstddef>
#include <cstdint>

namespace fog {

/// CRC-16/CCITT-FALSE of the sensor stream and the compact frame: polynomial 1021, initial FFFF,
/// not reflected, no final xor. Check value of "123456789": 29B1.
constexpr std::uint16_t kCrc16Initial = 0xFFFF;
std::uint16_t crc16(const std::uint8_t* bytes, std::size_t size, std::uint16_t crc = kCrc16Initial);

/// CRC-32/MPEG-2 of KVH's format A, the model table and the image: polynomial 04C11DB7, initial
/// FFFFFFFF, not reflected, no final xor. Check value of "123456789": 0376E6E7.
constexpr std::uint32_t kCrc32Initial = 0xFFFFFFFFU;
std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size, std::uint32_t crc = kCrc32Initial);

/// CRC-8/MAXIM-DOW of 1-Wire devices: polynomial 31, initial 0, reflected. Check value of
/// "123456789": A1.
std::uint8_t crc8(const std::uint8_t* bytes, std::size_t size);

}  // namespace fog
