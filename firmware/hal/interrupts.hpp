#pragma once

namespace fog::hal {

/// Between hold and release no interrupt is served; interrupts stay pending. A few microseconds at
/// most.
void hold_interrupts();
void release_interrupts();

}  // namespace fog::hal
