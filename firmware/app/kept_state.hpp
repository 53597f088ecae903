#pragma once

#include "hal/reset_report.hpp"

namespace fog::app {

/// The pipeline's state as of the last block, in memory that outlives a reset. It counts only with
/// its own CRC, and only for the very image, which has its model in it, that wrote it.

/// Writes it anew with the sample after each that ends a block, which has less to do; returns
/// whether this was one. Wants to be called after every sample: how old the state is is told by the
/// samples' numbers, which go round.
bool keep_state_if_due();

/// Where samples have stopped, nothing tells how old it is any more.
void forget_state();

/// Once, before the first sample, after a reset for this `cause`: goes on where it left off, if
/// there is one and the memory has had power ever since. Else forgets it.
void resume_state(hal::ResetCause cause);

}  // namespace fog::app
