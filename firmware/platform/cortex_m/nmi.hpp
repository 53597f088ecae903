#pragma once

#include "hal/reset_report.hpp"

namespace fog::platform {

/// What the board has connected to the interrupt that cannot be masked.
extern const hal::ResetCause kNmiMeans;

}  // namespace fog::platform
