#pragma once

namespace fog::platform {

/// Set-up of the processor before the application runs: exception vectors and enabled exceptions.
/// Called with interrupts disabled and memory initialised; leaves no interrupt enabled.
void prepare_processor();

/// Begins at the reset vector again; memory stays as it is, all that was written included.
[[noreturn]] void reset_processor();

}  // namespace fog::platform
