#pragma once

#include "hal/reset_report.hpp"

namespace fog::platform {

/// Restarts from the reset vector. `cause` and `crash` are kept in memory that start-up does not
/// initialise, because the hardware flags only show "software".
[[noreturn]] void restart(hal::ResetCause cause, const hal::CrashRecord& crash);

/// The same without a crash: the record of the last one is kept.
[[noreturn]] void restart(hal::ResetCause cause);

/// Fills hal::reset_report() with the cause stored by restart(), else with `hardware_cause`. Clears
/// the stored cause, so that it is not reported for the next reset. To be called once, at the
/// start.
void report_reset(hal::ResetCause hardware_cause);

}  // namespace fog::platform
