#pragma once

#include <cstdint>

namespace fog::platform {

/// Starts the millisecond tick behind hal/clock.hpp, for a processor running at `core_clock_hz`.
void start_tick(std::uint32_t core_clock_hz);

}  // namespace fog::platform
