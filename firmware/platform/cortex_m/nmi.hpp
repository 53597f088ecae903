#pragma once

#include "hal/reset_report.hpp"

namespace fog::platform {

/// Meaning of the non-maskable interrupt on this board.
extern const hal::ResetCause kNmiCause;

}  // namespace fog::platform
