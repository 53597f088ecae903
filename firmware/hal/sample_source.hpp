#pragma once

#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// Copies up to `capacity` bytes of the demodulator's sensor stream (SPEC.md, "Sensor stream") to
/// `destination` and returns their number; 0 if none. Never blocks. Bytes lost to a full buffer
/// show as a gap in the sequence numbers.
std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity);

}  // namespace fog::hal
