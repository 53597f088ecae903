#include "hal/lasting_clock.hpp"

#include "platform/stm32f405/peripherals.hpp"
#include "wiring.hpp"

// The real-time clock on the board's 32,768 Hz crystal, in the backup domain, which keeps its state
// over all resets but a loss of power (RM0090, 5.1.2). It is set once, to an arbitrary date: only
// differences matter.
namespace fog {
namespace platform {
namespace {

static_assert(kHasClockCrystal, "FOG_RESET_CLOCK=lse is for a board with a crystal of 32,768 Hz");

// The backup domain is write-protected after a reset.
void open_backup_domain() {
  enable_clock(apb_enable(Bus::kApb1), Rcc::kPower);
  power().control.set(Power::kBackupDomainWritable);
}

// The crystal takes up to 2 s. Another clock source, once selected, stays until power is lost.
bool crystal_drives_clock() {
  Register& domain = rcc().backup_domain;
  const std::uint32_t state = domain.read();
  if ((state & Rcc::kLseReady) == 0) {
    domain.set(Rcc::kLseOn);
    return false;
  }
  const std::uint32_t clock = state & (Rcc::kRtcClock | Rcc::kRtcOn);
  if (clock == 0) domain.set(Rcc::kRtcClockIsLse | Rcc::kRtcOn);
  return clock == (Rcc::kRtcClockIsLse | Rcc::kRtcOn);
}

void unlock() {
  rtc().key.write(Rtc::kUnlock1);
  rtc().key.write(Rtc::kUnlock2);
}

bool is_set() {
  constexpr std::uint32_t kOtherFormat = Rtc::kBypassShadow | Rtc::kTwelveHours;
  return rtc().status.any(Rtc::kHasYear) && rtc().prescaler.read() == Rtc::kSecondsOfLse &&
         !rtc().control.any(kOtherFormat);
}

// The clock can be set two of its periods after the request: in the next call.
void set() {
  unlock();
  if (rtc().status.any(Rtc::kMayBeSet)) {
    rtc().prescaler.write(Rtc::kSubsecondsLessOne);  // two separate writes (26.3.5)
    rtc().prescaler.write(Rtc::kSecondsOfLse);
    rtc().control.write(0);
    rtc().time.write(0);
    rtc().date.write(Rtc::kYear1);
    rtc().status.write(~(Rtc::kSet | Rtc::kSynchronised));
  } else {
    rtc().status.write(~0U);
  }
  rtc().key.write(Rtc::kLock);
}

std::uint32_t from_bcd(std::uint32_t digits) {
  return digits - 6U * (digits >> 4U);
}

// Months of 31 days, years of 12 months: a difference may be days too long, never too short.
std::uint64_t in_ms(std::uint32_t date, std::uint32_t time, std::uint32_t subsecond) {
  const std::uint32_t months = 12U * from_bcd(date >> 16U & 0xFFU) + from_bcd(date >> 8U & 0x1FU);
  const std::uint32_t days = 31U * months + from_bcd(date & 0x3FU);
  const std::uint32_t hours = 24U * days + from_bcd(time >> 16U & 0x3FU);
  const std::uint32_t minutes = 60U * hours + from_bcd(time >> 8U & 0x7FU);
  const std::uint32_t s = 60U * minutes + from_bcd(time & 0x7FU);
  const std::uint32_t part = (Rtc::kSubsecondsLessOne - subsecond) & Rtc::kSubsecondsLessOne;
  return std::uint64_t{s} * 1000U + part * 1000U / (Rtc::kSubsecondsLessOne + 1U);
}

// The first read should lock the others until the date is read, but does not always (ES0182, "RTC
// calendar registers are not locked properly"). If two reads are equal, the values between them are
// consistent.
hal::LastingTime read_clock() {
  const std::uint32_t subsecond = rtc().subsecond.read();
  const std::uint32_t time = rtc().time.read();
  const std::uint32_t date = rtc().date.read();
  const bool consistent = rtc().subsecond.read() == subsecond;
  static_cast<void>(rtc().date.read());  // unlocks them
  return {consistent, in_ms(date, time, subsecond)};
}

}  // namespace
}  // namespace platform

// A time that has been updated since the last call shows that the crystal runs.
hal::LastingTime hal::lasting_time() {
  using namespace platform;
  constexpr LastingTime kUnknown{false, 0};
  open_backup_domain();
  if (!crystal_drives_clock()) return kUnknown;
  if (!is_set()) {
    set();
    return kUnknown;
  }
  if (!rtc().status.any(Rtc::kSynchronised)) return kUnknown;
  const LastingTime now = read_clock();
  unlock();
  rtc().status.write(~(Rtc::kSet | Rtc::kSynchronised));
  rtc().key.write(Rtc::kLock);
  return now;
}

}  // namespace fog
