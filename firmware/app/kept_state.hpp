#pragma once

#include "hal/reset_report.hpp"

namespace fog::app {

/// The pipeline's state at the last block, in memory that outlives a reset. Valid only with its own
/// CRC and for the same image and model.

/// Writes the state with the sample after the end of a block, which has less other work; returns
/// whether it did. To be called after every sample, because the age of the state follows from the
/// sequence numbers, which wrap.
bool keep_state_if_due();

/// To be called when samples stop: from then on the age of the state is unknown.
void forget_state();

/// To be called once, before the first sample, after a reset with `cause`. Continues from the state
/// if it is valid and the memory has not lost power; else discards it.
void resume_state(hal::ResetCause cause);

}  // namespace fog::app
