#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/inputs.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// One value of an input other than the coil temperature (SPEC.md, "Sensor stream"). It belongs to
/// the sample that follows it. A demodulator sends the inputs it has, at any rate.
struct ExtensionRecord {
  Input input{};
  ExtensionValue value{};  ///< in the input's unit
};

constexpr std::size_t kExtensionFrameBytes = 10;
constexpr std::uint8_t kExtensionSync1 =
    0xC3;  ///< after kSensorSync0; differs from kSensorSync1 in four bits
using ExtensionFrame = std::array<std::uint8_t, kExtensionFrameBytes>;

/// Encodes a record: 10 bytes, CRC included.
ExtensionFrame encode_extension_frame(const ExtensionRecord& record);

/// Reads 10 bytes. Returns false, and leaves `record` unchanged, unless sync, CRC, reserved byte
/// and input number are valid.
bool decode_extension_frame(const std::uint8_t* bytes, ExtensionRecord& record);

}  // namespace fog
