#include "platform/cortex_m/restart.hpp"

#include <cstddef>

#include "core/protocol/crc.hpp"
#include "platform/cortex_m/system_control.hpp"

namespace fog {
namespace platform {
namespace {

// After power-on the memory holds anything; what it says counts only with its own CRC.
struct RestartRecord {
  std::uint32_t cause;  // a ResetCause; kNotRestarted after any reset that is not ours
  hal::CrashRecord crash;
  std::uint32_t crc;
};
constexpr std::uint32_t kNotRestarted = 0;

[[gnu::noinit]] RestartRecord record;

hal::ResetReport report{};

std::uint32_t crc_of(const RestartRecord& kept) {
  return crc32(reinterpret_cast<const std::uint8_t*>(&kept), offsetof(RestartRecord, crc));
}

void keep(std::uint32_t cause, const hal::CrashRecord& crash) {
  record.cause = cause;
  record.crash = crash;
  record.crc = crc_of(record);
}

}  // namespace

void restart(hal::ResetCause cause, const hal::CrashRecord& crash) {
  keep(static_cast<std::uint32_t>(cause), crash);
  asm volatile("dsb" ::: "memory");
  system_control_block().application_interrupt_and_reset.write(
      SystemControlBlock::kResetKeyAndRequest);
  asm volatile("dsb" ::: "memory");
  for (;;) {  // the reset takes a few cycles to arrive
  }
}

void restart(hal::ResetCause cause) {
  restart(cause, report.last_crash);
}

void report_reset(hal::ResetCause hardware_cause) {
  report = {hardware_cause, {}};
  if (record.crc == crc_of(record)) {
    report.last_crash = record.crash;
    if (record.cause != kNotRestarted) report.cause = static_cast<hal::ResetCause>(record.cause);
  }
  keep(kNotRestarted, report.last_crash);
}

}  // namespace platform

const hal::ResetReport& hal::reset_report() {
  return platform::report;
}

}  // namespace fog
