#pragma once

#include <cstdint>

namespace fog::hal {

/// Why the board started.
enum class ResetCause : std::uint8_t {
  unknown,
  power_on,
  brown_out,
  reset_pin,
  watchdog,       ///< the main loop stopped
  software,       ///< by a debugger, a boot loader, or after a table was loaded
  clock_failure,  ///< the crystal failed while it drove the core
  fault,          ///< an unhandled exception: see the crash record
  self_test,      ///< it found damaged memory while running
};

/// One or two words for the boot message.
const char* describe(ResetCause cause);

/// State of the processor at the last fatal exception. Outlives restarts, but not the loss of
/// power.
struct CrashRecord {
  std::uint32_t exception;        ///< number of the exception; 0: there was none
  std::uint32_t program_counter;  ///< 0 if the stack was unusable
  std::uint32_t link_register;    ///< 0 likewise
  std::uint32_t fault_status;     ///< CFSR: what kind of fault
  std::uint32_t fault_address;    ///< of the access, if fault_status marks it valid
  std::uint32_t uptime_ms;
};

/// Restarts by the board itself since the last power-on or reset by pin.
struct RestartCounts {
  std::uint32_t clock_failures;
  std::uint32_t faults;  ///< with watchdog and self-test; since the last good run
};

struct ResetReport {
  ResetCause cause;
  CrashRecord last_crash;
  RestartCounts counts;
};

/// Requires start_board().
const ResetReport& reset_report();

/// To be called when the board has run well for long enough: clears the fault counts.
void report_good_run();

}  // namespace fog::hal
