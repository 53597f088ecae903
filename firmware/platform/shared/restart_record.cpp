#include "platform/shared/restart_record.hpp"

#include "core/bytes/crc.hpp"

namespace fog::platform {
namespace {

constexpr auto kNotOurs = hal::ResetCause::unknown;

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
  if (!is_intact()) report_.counts = {};  // a start that fails before it has read the record
  report_.cause = cause;
  report_.last_crash = crash;
  crc_ = crc();
}

hal::ResetReport RestartRecord::take(hal::ResetCause hardware_cause) {
  if (!is_intact()) *this = RestartRecord();
  if (report_.cause == kNotOurs) report_.cause = hardware_cause;
  count(report_.counts, report_.cause);
  const hal::ResetReport taken = report_;
  report_.cause = kNotOurs;
  crc_ = crc();
  return taken;
}

void RestartRecord::forget_faults() {
  report_.counts.faults = 0;
  crc_ = crc();
}

bool RestartRecord::is_intact() const {
  return crc_ == crc();
}

std::uint32_t RestartRecord::crc() const {
  return crc32(reinterpret_cast<const std::uint8_t*>(this), sizeof *this - sizeof crc_);
}

}  // namespace fog::platform
