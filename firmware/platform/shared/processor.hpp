#pragma once

namespace fog::platform {

/// What start-up has to tell the processor before the application runs: where its exceptions go,
/// which of them it takes; interrupts are held off until then, none is left enabled. Each
/// processor's own; memory is initialised.
void prepare_processor();

/// Begins at the reset vector again; memory stays as it is, all that was written included.
[[noreturn]] void reset_processor();

}  // namespace fog::platform
