#pragma once

namespace fog::platform {

/// From here on an access that no correct program makes is a fault: to the guard under the stack,
/// a write to the image, an instruction fetched from RAM.
void protect_memory();

}  // namespace fog::platform
