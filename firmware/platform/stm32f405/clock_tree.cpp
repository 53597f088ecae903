#include "platform/stm32f405/clock_tree.hpp"

#include "platform/stm32f405/peripherals.hpp"
#include "wiring.hpp"

namespace fog::platform {
namespace {

constexpr std::uint32_t kInternalHz = 16'000'000;
constexpr std::uint32_t kCoreHz = 168'000'000;

// 2 MHz into the PLL, the value the reference manual recommends against jitter; 336 MHz inside.
constexpr std::uint32_t kPllInputHz = 2'000'000;
constexpr std::uint32_t kPllN = 168;
constexpr std::uint32_t kPllP = 2;
constexpr std::uint32_t kPllQ = 7;  // 48 MHz for USB and RNG: unused, but inside its limit
static_assert(kPllInputHz * kPllN / kPllP == kCoreHz);
static_assert(kCrystalHz % kPllInputHz == 0 && kInternalHz % kPllInputHz == 0,
              "the board's crystal must be a multiple of 2 MHz");

// 2.7 V to 3.6 V, 150 MHz to 168 MHz (RM0090, table 10).
constexpr std::uint32_t kFlashWaitStates = 5;

// A poll takes at least 5 cycles of the 16 MHz start-up clock, so this is at least 30 ms: a crystal
// needs 2 ms, the PLL 0.3 ms.
constexpr std::uint32_t kPolls = 100'000;

struct PllInput {
  std::uint32_t on;
  std::uint32_t ready;
  std::uint32_t selection;
  std::uint32_t hz;
  const char* name;
  bool is_fallback;
};

constexpr PllInput kCrystal{Rcc::kHseOn, Rcc::kHseReady, Rcc::kPllFromHse,
                            kCrystalHz,  "crystal",      false};
constexpr PllInput kInternal{Rcc::kHsiOn, Rcc::kHsiReady,        0,
                             kInternalHz, "internal oscillator", true};

constexpr ClockTree kAsResetLeftIt{
    kInternalHz, kInternalHz, kInternalHz, "internal oscillator, no PLL", true, false};

ClockTree running = kAsResetLeftIt;

bool lock_pll(const PllInput& input) {
  rcc().control.set(input.on);
  if (!wait_for_bits(rcc().control, input.ready, input.ready, kPolls)) return false;
  rcc().control.clear(Rcc::kPllOn);
  rcc().pll_configuration.replace(
      Rcc::kPllFields,
      input.selection | Rcc::pll_fields(input.hz / kPllInputHz, kPllN, kPllP, kPllQ));
  rcc().control.set(Rcc::kPllOn);
  return wait_for_bits(rcc().control, Rcc::kPllReady, Rcc::kPllReady, kPolls);
}

// The flash is slowed down before the core is sped up, and the new wait states are seen to be in
// force; the buses get their prescalers before the clock that needs them.
bool switch_to_pll() {
  flash().access_control.replace(Flash::kLatency, kFlashWaitStates | Flash::kPrefetchAndCaches);
  if (!wait_for_bits(flash().access_control, Flash::kLatency, kFlashWaitStates, kPolls)) {
    return false;
  }
  rcc().configuration.replace(Rcc::kPrescalers, Rcc::kApb1By4 | Rcc::kApb2By2);
  rcc().configuration.replace(Rcc::kSwitch, Rcc::kSwitchToPll);
  if (wait_for_bits(rcc().configuration, Rcc::kRunning, Rcc::kRunningFromPll, kPolls)) return true;
  rcc().configuration.replace(Rcc::kSwitch | Rcc::kPrescalers, Rcc::kSwitchToHsi);
  return false;
}

bool run_from(const PllInput& input) {
  if (!lock_pll(input) || !switch_to_pll()) return false;
  running = {kCoreHz, kCoreHz / 4U, kCoreHz / 2U, input.name, input.is_fallback, true};
  return true;
}

}  // namespace

void start_clock_tree() {
  running = kAsResetLeftIt;
  if (run_from(kCrystal)) {
    rcc().control.set(Rcc::kClockSecurityOn);
    return;
  }
  rcc().control.clear(Rcc::kHseOn);
  run_from(kInternal);
}

const ClockTree& clock_tree() {
  return running;
}

}  // namespace fog::platform
