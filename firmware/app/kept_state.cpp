#include "app/kept_state.hpp"

#include "app/pipeline.hpp"
#include "core/health/kept_words.hpp"

namespace fog::app {
namespace {

[[gnu::section(".noinit")]] KeptWords<Pipeline::kMostStateWords> kept;

// No other image has this, nor the same with another model.
std::uint32_t owner() {
  if constexpr (ModelTable::is_loaded) return seal_of_image() ^ model().key();
  return seal_of_image();
}

constexpr unsigned bit_of(hal::ResetCause cause) {
  return 1U << static_cast<unsigned>(cause);
}
using hal::ResetCause;
constexpr unsigned kPowerWasLost = bit_of(ResetCause::power_on) | bit_of(ResetCause::brown_out);
// The board restarts by itself at once. The reset pin may be held, and a debugger may stop the
// processor, for as long as anybody likes.
constexpr unsigned kOfItself = bit_of(ResetCause::watchdog) | bit_of(ResetCause::clock_failure) |
                               bit_of(ResetCause::fault) | bit_of(ResetCause::self_test);

}  // namespace

bool keep_state_if_due() {
  static bool block_ended = false;
  const bool due = block_ended;
  block_ended = pipeline().ended_block();
  if (due) kept.seal(pipeline().keep(kept.words()), owner());
  return due;
}

void forget_state() {
  kept.forget();
}

void resume_state(hal::ResetCause cause) {
  const unsigned bit = bit_of(cause);
  if ((bit & kPowerWasLost) == 0 && kept.are_intact(owner())) {
    pipeline().resume(kept.words(), (bit & kOfItself) != 0);
  } else {
    forget_state();
  }
}

}  // namespace fog::app
