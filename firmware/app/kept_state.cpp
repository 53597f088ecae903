#include "app/kept_state.hpp"

#include "app/pipeline.hpp"
#include "core/health/kept_words.hpp"
#include "hal/clock.hpp"
#include "hal/lasting_clock.hpp"

namespace fog::app {
namespace {

// Whether the board has a clock that runs during a reset (FOG_RESET_CLOCK of the build). Without
// one this code takes neither flash nor time.
constexpr bool kHasLastingClock = FOG_RESET_CLOCK != 0;

// Time at which the state was written, after the words.
using KeptTime = std::uint64_t;
constexpr std::size_t kTimeWords = kHasLastingClock ? sizeof(KeptTime) / sizeof(std::uint32_t) : 0;
constexpr KeptTime kUnknown = ~KeptTime{0};

[[gnu::section(".noinit")]] KeptWords<Pipeline::kMaxStateWords + kTimeWords> kept;

KeptTime lasting_ms() {
  const hal::LastingTime now = hal::lasting_time();
  return now.known ? now.ms : kUnknown;
}

std::size_t keep_words() {
  const std::size_t size = pipeline().keep(kept.words());
  if constexpr (!kHasLastingClock) return size;
  const KeptTime now = lasting_ms();
  __builtin_memcpy(kept.words() + size, &now, sizeof now);
  return size == 0 ? 0 : size + kTimeWords;
}

// Arrival time of the newest sample of the state, by the clock of this start. Unknown after a day:
// by then the state is useless, and the milliseconds are about to wrap.
[[maybe_unused]] SampleTime newest_sample() {
  constexpr KeptTime kMaxMs = 86'400'000;
  KeptTime then = 0;
  __builtin_memcpy(&then, kept.words() + kept.size() - kTimeWords, sizeof then);
  const KeptTime now = lasting_ms();
  const bool known =
      hal::clock_is_accurate() && then != kUnknown && now != kUnknown && now - then < kMaxMs;
  return {known, hal::milliseconds() - static_cast<std::uint32_t>(now - then)};
}

// Unique to this image and its model.
std::uint32_t owner() {
  if constexpr (ModelTable::is_loaded) return seal_of_image() ^ model().key();
  return seal_of_image();
}

constexpr unsigned bit_of(hal::ResetCause cause) {
  return 1U << static_cast<unsigned>(cause);
}
using hal::ResetCause;
constexpr unsigned kPowerWasLost = bit_of(ResetCause::power_on) | bit_of(ResetCause::brown_out);
// Causes after which the board restarts at once. The reset pin or a debugger may stop the processor
// for any time.
constexpr unsigned kOwnRestarts = bit_of(ResetCause::watchdog) | bit_of(ResetCause::clock_failure) |
                                  bit_of(ResetCause::fault) | bit_of(ResetCause::self_test);

}  // namespace

bool keep_state_if_due() {
  static bool block_ended = false;
  const bool due = block_ended;
  block_ended = pipeline().ended_block();
  if (due) kept.seal(keep_words(), owner());
  return due;
}

void forget_state() {
  kept.forget();
}

void resume_state(hal::ResetCause cause) {
  const unsigned bit = bit_of(cause);
  if ((bit & kPowerWasLost) == 0 && kept.are_intact(owner())) {
    if constexpr (kHasLastingClock) {
      const SampleTime newest = newest_sample();
      if (newest.known) return pipeline().resume_after(kept.words(), newest);
    }
    pipeline().resume(kept.words(), (bit & kOwnRestarts) != 0);
  } else {
    forget_state();
  }
}

}  // namespace fog::app
