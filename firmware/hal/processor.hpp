#pragma once

#include <array>
#include <cstdint>

namespace fog::hal {

/// Unique number of the processor; all 0 if there is none or it cannot be read.
using ProcessorNumber = std::array<std::uint32_t, 3>;

/// Requires start_board().
ProcessorNumber processor_number();

}  // namespace fog::hal
