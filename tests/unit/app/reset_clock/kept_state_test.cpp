// State that outlives a reset on a board with a clock that runs while the reset pin is held. The
// state is as flashed; this test is the board.
#include "app/kept_state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <new>

#include "app/pipeline.hpp"
#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "hal/lasting_clock.hpp"
#include "hal/memory_map.hpp"
#include "hal/processor.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"

namespace {

constexpr std::uint32_t kPeriodMs = 5;

struct Board {
  std::uint32_t now_ms = 0;  // since the start
  std::uint64_t lasting_ms = 1'000'000;
  bool clock_known = true;
  std::uint32_t samples = 0;  // of the demodulator, which goes on as well
  std::uint16_t first_number = 0;
};
Board board;

const std::array<std::uint8_t, 4> kNoImage{};
std::array<std::uint32_t, 4> memory;

}  // namespace

namespace fog {
namespace hal {

std::uint32_t milliseconds() {
  return board.now_ms;
}
bool clock_is_accurate() {
  return true;
}
LastingTime lasting_time() {
  return {board.clock_known, board.lasting_ms};
}
void hold_interrupts() {}
void release_interrupts() {}
void write_console(const char*) {}
MemoryMap memory_map() {
  return {kNoImage.data(), kNoImage.data() + kNoImage.size(), memory.data(),
          memory.data() + memory.size(), memory.data()};
}
ProcessorNumber processor_number() {
  return {};
}

}  // namespace hal
void platform::restart_board() {
  throw 0;
}
}  // namespace fog

namespace {

using fog::OutputSample;
using fog::Status;
using fog::app::pipeline;
using fog::hal::ResetCause;

void pass(std::uint32_t ms) {
  board.now_ms += ms;
  board.lasting_ms += ms;
  board.samples += ms / kPeriodMs;
}

// In a ramp of 3 degC/min, from 25 degC on.
OutputSample next_sample() {
  pass(kPeriodMs);
  const auto number = static_cast<std::uint16_t>(board.first_number + board.samples);
  const auto temperature = (25 << 16) + static_cast<std::int32_t>(board.samples) * 4;
  pipeline().process({number, 700 + number % 7, temperature, true, true}, {true, board.now_ms});
  return pipeline().last();
}

OutputSample run(std::uint32_t samples) {
  OutputSample last;
  for (std::uint32_t i = 0; i < samples; ++i) {
    last = next_sample();
    fog::app::keep_state_if_due();
  }
  return last;
}

// Holds the pin for this time; then the board restarts.
void reset(std::uint32_t held_ms, ResetCause cause = ResetCause::reset_pin) {
  pass(held_ms);
  board.now_ms = 100;
  pipeline().~Compensator();
  const auto& parameters = fog::app::model().parameters;
  new (&pipeline()) fog::app::Pipeline(parameters, fog::IntegrityToken::not_needed());
  fog::app::resume_state(cause);
}

class KeptStateWithAClock : public testing::Test {
 protected:
  KeptStateWithAClock() { settle(); }

  static void settle() {
    board = Board();
    fog::app::forget_state();
    reset(0);
    run(200 * 400);
  }
};

double degph(const OutputSample& sample) {
  return static_cast<double>(sample.drift.raw()) / (1 << fog::Rate::fractional_bits);
}

// 30 s, and ten more after it.
TEST_F(KeptStateWithAClock, AHeldResetPinIsAGapLikeAnyOther) {
  run(200 * 30);
  const double expected = degph(run(200 * 10));
  settle();
  reset(30'000);
  const OutputSample last = run(200 * 10);
  EXPECT_NEAR(degph(last), expected, 0.005);
  EXPECT_TRUE(has_any(last.status, Status::thermal_settling)) << "three times as long as the gap";
  EXPECT_FALSE(has_any(run(200 * 90).status, Status::thermal_settling));

  settle();
  board.clock_known = false;
  reset(30'000);
  EXPECT_GT(std::abs(degph(run(200 * 10)) - expected), 0.05) << "without the clock: anew";
  EXPECT_TRUE(has_any(run(200 * 90).status, Status::thermal_settling));
}

TEST_F(KeptStateWithAClock, AClockThatIsNotKnownAtEitherEndIsNone) {
  board.clock_known = false;
  run(400);  // written without
  board.clock_known = true;
  reset(1'000);
  EXPECT_TRUE(has_any(run(200 * 20).status, Status::thermal_settling));
}

// 65,536 samples are 328 s: by sequence numbers alone this gap would be half a second.
TEST_F(KeptStateWithAClock, AGapOfAWholeRoundOfTheNumbersIsNotTakenForAShortOne) {
  reset(65'536 * kPeriodMs + 500);
  EXPECT_TRUE(has_any(run(200 * 40).status, Status::thermal_settling)) << "it started anew";
}

TEST_F(KeptStateWithAClock, ADemodulatorThatWasResetAsWellIsNotBelievedHowLongItWas) {
  board.first_number = static_cast<std::uint16_t>(20'000 - board.samples);
  reset(2'000);
  EXPECT_FALSE(has_any(run(200 * 12).status, Status::thermal_settling)) << "a gap of 2 s, over";
}

TEST_F(KeptStateWithAClock, NothingOutlivesTheLossOfPower) {
  reset(100, ResetCause::power_on);
  const OutputSample first = next_sample();
  EXPECT_TRUE(has_any(first.status, Status::drift_given_up));
}

}  // namespace
