#pragma once

#include "hal/reset_report.hpp"

namespace fog::platform {

/// Restarts from the reset vector. `cause` and `crash` outlive it in memory that start-up leaves
/// alone, because the hardware's own flags only know "software".
[[noreturn]] void restart(hal::ResetCause cause, const hal::CrashRecord& crash);

/// The same without a crash: the record of the last one stays.
[[noreturn]] void restart(hal::ResetCause cause);

/// Fills hal::reset_report(): with the cause given to the restart that led here, else with
/// `hardware_cause`. Forgets the former, so that it is not taken for the cause of the next reset.
/// Once, at the start.
void report_reset(hal::ResetCause hardware_cause);

}  // namespace fog::platform
