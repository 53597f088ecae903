#include "platform/shared/restart_record.hpp"

#include "core/bytes/crc.hpp"

namespace fog::platform {
namespace {

constexpr auto kNotOurs = static_cast<std::uint32_t>(hal::ResetCause::unknown);

void count(hal::RestartCounts& counts, hal::ResetCause cause) {
  using hal::ResetCause;
  if (cause == ResetCause::power_on || cause == ResetCause::reset_pin) counts = {};
  if (cause == ResetCause::clock_failure) ++counts.clock_failures;
  const bool failed =
      cause == ResetCause::fault || cause == ResetCause::watchdog || cause == ResetCause::self_test;
  if (failed) ++counts.faults;
}

}  // namespace

void RestartRecord::keep(hal::ResetCause cause, const hal::CrashRecord& crash) {
  const bool known = crc_ == crc();  // not where a start fails before it has taken the record
  seal(static_cast<std::uint32_t>(cause), crash, known ? counts_ : hal::RestartCounts{});
}

hal::ResetReport RestartRecord::take(hal::ResetCause hardware_cause) {
  hal::ResetReport report{hardware_cause, {}, {}};
  if (crc_ == crc()) {
    report.last_crash = crash_;
    if (cause_ != kNotOurs) report.cause = static_cast<hal::ResetCause>(cause_);
    report.counts = counts_;
    count(report.counts, report.cause);
  }
  seal(kNotOurs, report.last_crash, report.counts);
  return report;
}

void RestartRecord::forget_faults() {
  seal(cause_, crash_, {counts_.clock_failures, 0});
}

void RestartRecord::seal(std::uint32_t cause, const hal::CrashRecord& crash,
                         const hal::RestartCounts& counts) {
  cause_ = cause;
  crash_ = crash;
  counts_ = counts;
  crc_ = crc();
}

std::uint32_t RestartRecord::crc() const {
  return crc32(reinterpret_cast<const std::uint8_t*>(this), sizeof *this - sizeof crc_);
}

}  // namespace fog::platform
