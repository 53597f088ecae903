#pragma once

#include <cstdint>

namespace fog {

/// Integers to and from the bytes of a frame, independent of the processor's byte order and
/// alignment.
inline void store_le16(std::uint8_t* to, std::uint16_t value) {
  to[0] = static_cast<std::uint8_t>(value);
  to[1] = static_cast<std::uint8_t>(value >> 8U);
}

inline void store_le32(std::uint8_t* to, std::uint32_t value) {
  store_le16(to, static_cast<std::uint16_t>(value));
  store_le16(to + 2, static_cast<std::uint16_t>(value >> 16U));
}

inline void store_be16(std::uint8_t* to, std::uint16_t value) {
  to[0] = static_cast<std::uint8_t>(value >> 8U);
  to[1] = static_cast<std::uint8_t>(value);
}

inline void store_be32(std::uint8_t* to, std::uint32_t value) {
  store_be16(to, static_cast<std::uint16_t>(value >> 16U));
  store_be16(to + 2, static_cast<std::uint16_t>(value));
}

inline std::uint16_t load_le16(const std::uint8_t* from) {
  return static_cast<std::uint16_t>(from[0] | (from[1] << 8U));
}

inline std::uint32_t load_le32(const std::uint8_t* from) {
  return load_le16(from) | (static_cast<std::uint32_t>(load_le16(from + 2)) << 16U);
}

}  // namespace fog
