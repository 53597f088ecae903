#include "hal/watchdog.hpp"

#include "platform/stm32f405/peripherals.hpp"

namespace fog::hal {
namespace {

// The watchdog has its own oscillator (LSI), so that it works even if every other clock has failed.
// Timeouts assume the nominal 32 kHz; the data sheet allows 17 kHz to 47 kHz: 68 ms to 188 ms for
// 100 ms.
constexpr std::uint32_t kLsiHz = 32'000;
constexpr std::uint32_t kPrescaleBy16 = 2;
constexpr std::uint32_t kPrescaleBy256 = 6;
constexpr std::uint32_t kTicksPerMs = kLsiHz / 16U / 1000U;
constexpr std::uint32_t kMsPerSlowTick = 256U * 1000U / kLsiHz;
static_assert(2000 * kTicksPerMs <= 4096, "the counter has 12 bits");

// Settings reach the watchdog within five periods of its oscillator, 0.3 ms.
constexpr std::uint32_t kUpdatePolls = 100'000;

[[gnu::always_inline]] inline void start(std::uint32_t prescaler, std::uint32_t ticks) {
  auto& watchdog = platform::watchdog();
  using Keys = platform::IndependentWatchdog;
  watchdog.key.write(Keys::kStart);
  watchdog.key.write(Keys::kUnlock);
  watchdog.prescaler.write(prescaler);
  watchdog.reload.write(ticks - 1U);
  platform::wait_for_bits(watchdog.status, Keys::kUpdating, 0, kUpdatePolls);
  watchdog.key.write(Keys::kKick);
}

}  // namespace

void start_watchdog(std::uint32_t timeout_ms) {
  start(kPrescaleBy16, timeout_ms * kTicksPerMs);
}

void extend_watchdog(std::uint32_t timeout_ms) {
  start(kPrescaleBy256, timeout_ms / kMsPerSlowTick);
}

void kick_watchdog() {
  platform::watchdog().key.write(platform::IndependentWatchdog::kKick);
}

}  // namespace fog::hal
