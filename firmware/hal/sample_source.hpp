#pragma once

#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// Copies up to `capacity` bytes of the demodulator's sensor stream (SPEC.md, "Sensor stream") to
/// `destination` and returns how many: 0 where none has arrived. Never blocks, never drops a byte
/// silently: bytes lost to a full buffer show as a gap in the stream's sequence numbers.
std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity);

}  // namespace fog::hal
