#pragma once

#include "hal/reset_report.hpp"

namespace fog::platform {

/// Reads the reset flags and clears them, so that the next reset finds only its own.
hal::ResetCause take_hardware_reset_cause();

}  // namespace fog::platform
