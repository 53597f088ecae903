#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/inputs.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// One value of an input beside the coil's temperature (SPEC.md, "Sensor stream"). It belongs to
/// the sample that follows it. A demodulator sends those it has, as often as it has them.
struct ExtensionRecord {
  Input input{};
  ExtensionValue value{};  ///< in the input's unit
};

constexpr std::size_t kExtensionFrameBytes = 10;
constexpr std::uint8_t kExtensionSync1 = 0xC3;  ///< after kSensorSync0; four bits off kSensorSync1
using ExtensionFrame = std::array<std::uint8_t, kExtensionFrameBytes>;

/// The 10 bytes of a record, CRC included.
ExtensionFrame encode_extension_frame(const ExtensionRecord& record);

/// Reads 10 bytes. Returns false, and leaves `record` alone, unless sync, CRC, the reserved byte
/// and the input's number are all as they must be.
bool decode_extension_frame(const std::uint8_t* bytes, ExtensionRecord& record);

}  // namespace fog
