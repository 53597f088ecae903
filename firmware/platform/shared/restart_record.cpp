#include "platform/shared/restart_record.hpp"

#include "core/bytes/crc.hpp"

namespace fog::platform {
namespace {

constexpr auto kNotOurs = static_cast<std::uint32_t>(hal::ResetCause::unknown);

}  // namespace

void RestartRecord::keep(hal::ResetCause cause, const hal::CrashRecord& crash) {
  seal(static_cast<std::uint32_t>(cause), crash);
}

hal::ResetReport RestartRecord::take(hal::ResetCause hardware_cause) {
  hal::ResetReport report{hardware_cause, {}};
  if (crc_ == crc()) {
    report.last_crash = crash_;
    if (cause_ != kNotOurs) report.cause = static_cast<hal::ResetCause>(cause_);
  }
  seal(kNotOurs, report.last_crash);
  return report;
}

void RestartRecord::seal(std::uint32_t cause, const hal::CrashRecord& crash) {
  cause_ = cause;
  crash_ = crash;
  crc_ = crc();
}

std::uint32_t RestartRecord::crc() const {
  return crc32(reinterpret_cast<const std::uint8_t*>(this), sizeof *this - sizeof crc_);
}

}  // namespace fog::platform
