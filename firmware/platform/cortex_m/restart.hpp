#pragma once

#include <cstdint>

namespace fog::platform {

/// Why the firmware restarted itself. It outlives the restart in memory that start-up leaves alone,
/// because the hardware's own flags only know "software".
enum class RestartReason : std::uint32_t { kNone, kFault, kRequest };

[[noreturn]] void restart(RestartReason reason);

/// The reason given to the restart that led here; kNone after any other reset. Forgets it, so that
/// it is not taken for the reason of the next one.
RestartReason take_restart_reason();

}  // namespace fog::platform
