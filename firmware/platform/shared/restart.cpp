#include "platform/shared/restart.hpp"

#include "platform/shared/processor.hpp"
#include "platform/shared/restart_record.hpp"

namespace fog {
namespace platform {
namespace {

[[gnu::noinit]] RestartRecord record;

hal::ResetReport report{};

}  // namespace

void restart(hal::ResetCause cause, const hal::CrashRecord& crash) {
  record.keep(cause, crash);
  reset_processor();
}

void restart(hal::ResetCause cause) {
  restart(cause, report.last_crash);
}

void report_reset(hal::ResetCause hardware_cause) {
  report = record.take(hardware_cause);
}

}  // namespace platform

const hal::ResetReport& hal::reset_report() {
  return platform::report;
}

void hal::report_good_run() {
  platform::record.forget_faults();
}

}  // namespace fog
