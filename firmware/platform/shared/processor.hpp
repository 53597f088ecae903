#pragma once

namespace fog::platform {

/// Set-up of the processor before the application runs: exception vectors and enabled exceptions.
/// Called with interrupts disabled and memory initialised; leaves no interrupt enabled.
void prepare_processor();

}  // namespace fog::platform
