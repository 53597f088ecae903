#include "support/stm32_backup_domain.hpp"

#include <cmath>
#include <ctime>

namespace fog::test {
namespace {

constexpr double kPeriodS = 1.0 / 32'768;
constexpr double kSteps = 256;
// 2001-01-01 00:00:00, in seconds of Unix.
constexpr double kYear1 = 978'307'200;

// Offsets of the registers: 26.6.
constexpr std::uint32_t kTime = 0x00;
constexpr std::uint32_t kDate = 0x04;
constexpr std::uint32_t kRtcControl = 0x08;
constexpr std::uint32_t kStatus = 0x0C;
constexpr std::uint32_t kPrescaler = 0x10;
constexpr std::uint32_t kKey = 0x24;
constexpr std::uint32_t kSubsecond = 0x28;

std::uint32_t bcd(int value) {
  return static_cast<std::uint32_t>(value / 10 * 16 + value % 10);
}

}  // namespace

bool Stm32BackupDomain::crystal_ready(double now_s) const {
  return has_crystal && (control_ & 1U) != 0 && now_s >= crystal_on_s_ + crystal_start_s;
}

bool Stm32BackupDomain::clock_runs(double now_s) const {
  return crystal_ready(now_s) && (control_ & 0x8300U) == 0x8100U;
}

double Stm32BackupDomain::counted_s(double now_s) const {
  return now_s - started_at_s_;
}

double Stm32BackupDomain::to_next_step_s(double now_s) const {
  const double steps = counted_s(now_s) * kSteps;
  return (std::floor(steps) + 1 - steps) / kSteps;
}

// Every two periods, unless a read holds them (26.3.6).
void Stm32BackupDomain::copy(double now_s) {
  if (!clock_runs(now_s) || init_ || held_ || now_s < copies_from_s_) return;
  copied_s_ = counted_s(now_s);
  synchronised_ = true;
}

std::uint32_t Stm32BackupDomain::calendar(std::uint32_t offset, double at_s) const {
  const auto seconds = static_cast<std::time_t>(kYear1 + std::floor(at_s));
  if (offset == kSubsecond) {
    return static_cast<std::uint32_t>(kSteps - 1 - std::floor((at_s - std::floor(at_s)) * kSteps));
  }
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  if (offset == kTime) {
    return bcd(parts.tm_hour) << 16U | bcd(parts.tm_min) << 8U | bcd(parts.tm_sec);
  }
  return bcd(parts.tm_year - 100) << 16U | 1U << 13U | bcd(parts.tm_mon + 1) << 8U |
         bcd(parts.tm_mday);
}

std::uint32_t Stm32BackupDomain::read(std::uint32_t address, double now_s) {
  if (address == kControl) return control_ | (crystal_ready(now_s) ? 2U : 0U);
  const std::uint32_t offset = address - kRtc;
  copy(now_s);
  const bool may_be_set = init_ && clock_runs(now_s) && now_s >= init_at_s_ + 2 * kPeriodS;
  if (offset == kStatus) {
    return 7U | (has_year_ ? 1U << 4U : 0U) | (synchronised_ ? 1U << 5U : 0U) |
           (may_be_set ? 1U << 6U : 0U) | (init_ ? 1U << 7U : 0U);
  }
  if (offset == kRtcControl) return rtc_control_;
  if (offset == kPrescaler) return prescaler_;
  if (offset != kTime && offset != kDate && offset != kSubsecond) return 0;
  if (!synchronised_) violate_("time read before it was copied");
  held_ = holds_while_read && offset != kDate;
  return calendar(offset, holds_while_read ? copied_s_ : counted_s(now_s));
}

void Stm32BackupDomain::write(std::uint32_t address, std::uint32_t value, double now_s) {
  if (!writable) return violate_("backup domain written while it is protected");
  if (address == kControl) {
    if ((value & 1U) != 0 && (control_ & 1U) == 0) crystal_on_s_ = now_s;
    if ((control_ & 0x300U) != 0 && ((value ^ control_) & 0x300U) != 0) {
      violate_("clock of the RTC changed");
      value = (value & ~0x300U) | (control_ & 0x300U);
    }
    control_ = value & 0x8305U;
    return;
  }
  const std::uint32_t offset = address - kRtc;
  if (offset == kKey) {
    unlocked_ = half_unlocked_ && value == 0x53;
    half_unlocked_ = value == 0xCA;
    return;
  }
  if (!unlocked_) return violate_("RTC written while it is protected");
  if (offset == kStatus) return write_status(value, now_s);
  const bool may_be_set = init_ && now_s >= init_at_s_ + 2 * kPeriodS;
  if (!may_be_set) return violate_("RTC set outside its initialisation");
  write_rtc(offset, value);
  started_at_s_ = now_s;
}

// 26.3.5: the clock starts when the initialisation ends, and copies after four periods.
void Stm32BackupDomain::write_status(std::uint32_t value, double now_s) {
  const bool init = (value & 1U << 7U) != 0;
  if (init && !init_) init_at_s_ = now_s;
  if (!init && init_) started_at_s_ = now_s;
  if (init || init_ || (value & 1U << 5U) == 0) {
    synchronised_ = false;
    copies_from_s_ = now_s + (init_ ? 4 : 2) * kPeriodS;
  }
  init_ = init;
}

void Stm32BackupDomain::write_rtc(std::uint32_t offset, std::uint32_t value) {
  if (offset == kTime && value != 0) violate_("this model begins at midnight");
  if (offset == kDate) {
    if (value != 0x00012101) violate_("this model begins with year 1, a Monday");
    has_year_ = true;
  }
  if (offset == kRtcControl) rtc_control_ = value;
  if (offset == kPrescaler) {  // two writes, the synchronous half first
    const std::uint32_t mask = first_half_written_ ? 0x7F0000U : 0x7FFFU;
    prescaler_ = (prescaler_ & ~mask) | (value & mask);
    first_half_written_ = !first_half_written_;
  }
}

// 26.6.4, 5.4.1. What protects the RTC stays as it was.
void Stm32BackupDomain::system_reset() {
  writable = false;
  init_ = false;
  synchronised_ = false;
  held_ = false;
}

}  // namespace fog::test
