#pragma once

#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// Copies up to `capacity` bytes, received on the output port, to `destination` and returns their
/// number; 0 if none. Never blocks. Requests are short and rare: bytes that are not read in time
/// may be lost.
std::size_t read_requests(std::uint8_t* destination, std::size_t capacity);

}  // namespace fog::hal
