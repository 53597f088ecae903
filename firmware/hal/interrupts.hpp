#pragma once

namespace fog::hal {

/// Between the two no interrupt is served; those that come wait. For a few microseconds at most.
void hold_interrupts();
void release_interrupts();

}  // namespace fog::hal
