#pragma once

namespace fog::platform {

/// From here on an access that no correct program makes is a fault: to the guard under the stack,
/// a write to the image, an instruction fetched from RAM.
void protect_memory();

/// Whether the 16 KiB of flash from `start` on, a multiple of that, may be written, which the image
/// may not. One such place at a time.
void allow_writes(const void* start, bool allowed);

}  // namespace fog::platform
