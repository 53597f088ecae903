#include "platform/stm32f405/clock_tree.hpp"

#include "hal/clock.hpp"
#include "platform/stm32f405/peripherals.hpp"
#include "wiring.hpp"

namespace fog::platform {
namespace {

constexpr std::uint32_t kInternalHz = 16'000'000;

// 144 MHz instead of the maximum of 168 MHz: every bit rate is within 0.2 %, which leaves its
// tolerance to the internal oscillator; the oscillator's error over temperature, trim included,
// keeps the core within its limits; flash and regulator allow it at any supply at which the part
// starts. At 200 samples per second the core is idle for 98 % of the time.
constexpr std::uint32_t kCoreHz = 144'000'000;

// PLL input: 2 MHz, recommended by the reference manual against jitter, or 1 MHz if the source is
// no multiple of 2 MHz. VCO: 288 MHz.
constexpr std::uint32_t kPllInsideHz = 288'000'000;
constexpr std::uint32_t kPllP = kPllInsideHz / kCoreHz;
constexpr std::uint32_t kPllQ = 6;  // 48 MHz for USB and RNG: unused, but within its limit
constexpr std::uint32_t pll_input_hz(std::uint32_t hz) {
  return hz % 2'000'000 == 0 ? 2'000'000 : 1'000'000;
}
constexpr std::uint32_t pll_setting(std::uint32_t hz) {
  const std::uint32_t input_hz = pll_input_hz(hz);
  return Rcc::pll_fields(hz / input_hz, kPllInsideHz / input_hz, kPllP, kPllQ);
}
static_assert(kCrystalHz % 1'000'000 == 0 && kCrystalHz >= 4'000'000 && kCrystalHz <= 26'000'000,
              "the board's crystal must be a multiple of 1 MHz");

// Up to 160 MHz at 1.8 V, prefetch off (RM0090, table 10).
constexpr std::uint32_t kFlashWaitStates = 7;

// A poll takes at least 5 cycles of the 16 MHz start-up clock, so this is at least 30 ms. A crystal
// needs 2 ms, the PLL 0.3 ms.
constexpr std::uint32_t kPolls = 100'000;

struct PllInput {
  std::uint32_t on;
  std::uint32_t ready;
  std::uint32_t setting;
  const char* name;
  bool is_fallback;
};

constexpr PllInput kCrystal{Rcc::kHseOn | (kCrystalIsOscillator ? Rcc::kHseBypass : 0),
                            Rcc::kHseReady, Rcc::kPllFromHse | pll_setting(kCrystalHz),
                            kCrystalIsOscillator ? "oscillator" : "crystal", false};
constexpr PllInput kInternal{Rcc::kHsiOn, Rcc::kHsiReady, pll_setting(kInternalHz),
                             "internal oscillator", true};

constexpr ClockTree kAsResetLeftIt{
    kInternalHz, {kInternalHz, kInternalHz}, "internal oscillator, no PLL", true, false};

ClockTree running;  // from start_clock_tree() on

// Restores the reset state of the clocks, whatever a boot loader or a debugger has set: a PLL that
// is the system clock cannot be stopped, and a running one cannot be changed (7.3.1, 7.3.2).
bool return_to_internal() {
  rcc().control.set(Rcc::kHsiOn);
  if (!wait_for_bits(rcc().control, Rcc::kHsiReady, Rcc::kHsiReady, kPolls)) return false;
  rcc().configuration.replace(Rcc::kSwitch, Rcc::kSwitchToHsi);
  if (!wait_for_bits(rcc().configuration, Rcc::kRunning, Rcc::kRunningFromHsi, kPolls)) {
    return false;
  }
  rcc().configuration.clear(Rcc::kPrescalers);
  rcc().control.clear(Rcc::kPllOn | Rcc::kClockSecurityOn | Rcc::kHseOn);
  rcc().control.clear(Rcc::kHseBypass);  // only while it is off
  return wait_for_bits(rcc().control, Rcc::kPllReady, 0, kPolls);
}

bool lock_pll(const PllInput& input) {
  rcc().control.set(input.on & Rcc::kHseBypass);
  rcc().control.set(input.on);
  if (!wait_for_bits(rcc().control, input.ready, input.ready, kPolls)) return false;
  rcc().pll_configuration.replace(Rcc::kPllFields, input.setting);
  if ((rcc().pll_configuration.read() & Rcc::kPllFields) != input.setting) return false;
  rcc().control.set(Rcc::kPllOn);
  return wait_for_bits(rcc().control, Rcc::kPllReady, Rcc::kPllReady, kPolls);
}

// Order: flash wait states, verified, before the faster clock; bus prescalers before the clock that
// needs them.
bool switch_to_pll() {
  flash().access_control.write(kFlashWaitStates | Flash::kCaches);
  if (!wait_for_bits(flash().access_control, Flash::kLatency, kFlashWaitStates, kPolls)) {
    return false;
  }
  rcc().configuration.replace(Rcc::kPrescalers, Rcc::kApb1By4 | Rcc::kApb2By2);
  rcc().configuration.replace(Rcc::kSwitch, Rcc::kSwitchToPll);
  return wait_for_bits(rcc().configuration, Rcc::kRunning, Rcc::kRunningFromPll, kPolls);
}

bool run_from(const PllInput& input) {
  if (!return_to_internal()) return false;
  if (!lock_pll(input) || !switch_to_pll()) {
    return_to_internal();
    return false;
  }
  running = {kCoreHz, {kCoreHz / 4U, kCoreHz / 2U}, input.name, input.is_fallback, true};
  return true;
}

}  // namespace

void start_clock_tree(bool try_crystal) {
  running = kAsResetLeftIt;
  rcc().ahb1_reset.write(Rcc::kBusMasters);  // a boot loader may have left transfers running
  rcc().ahb1_reset.write(0);
  if (try_crystal && run_from(kCrystal)) {
    rcc().control.set(Rcc::kClockSecurityOn);
  } else {
    run_from(kInternal);
  }
}

const ClockTree& clock_tree() {
  return running;
}

}  // namespace fog::platform

// In steps of 5 of 32 positions (a quarter of a percent each): all are tried, and consecutive ones
// are near each other.
void fog::hal::try_another_speed() {
  using platform::Rcc;
  if (!platform::running.is_fallback) return;
  auto& control = platform::rcc().control;
  control.replace(Rcc::kHsiTrim, (control.read() + Rcc::hsi_trim(5)) & Rcc::kHsiTrim);
}
