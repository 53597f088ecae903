#pragma once

#include <array>
#include <cstdint>

namespace fog::hal {

/// The number that no other processor of its kind has; all 0 where there is none, or it cannot be
/// read.
using ProcessorNumber = std::array<std::uint32_t, 3>;

/// Valid once the board has been started.
ProcessorNumber processor_number();

}  // namespace fog::hal
