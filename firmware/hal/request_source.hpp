#pragma once

#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// Copies up to `capacity` bytes that the user has sent to the output port to `destination` and
/// returns how many: 0 where none has arrived. Never blocks. Requests are short and rare: what
/// comes while nobody reads may be lost.
std::size_t read_requests(std::uint8_t* destination, std::size_t capacity);

}  // namespace fog::hal
