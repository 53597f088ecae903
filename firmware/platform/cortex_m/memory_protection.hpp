#pragma once

namespace fog::platform {

/// From now on these accesses are faults: to the guard below the stack, a write to the image, an
/// instruction fetch from RAM.
void protect_memory();

/// Allows or forbids writes to the 16 KiB of flash from `start` (aligned to that size); the image
/// stays write-protected. One area at a time.
void allow_writes(const void* start, bool allowed);

}  // namespace fog::platform
