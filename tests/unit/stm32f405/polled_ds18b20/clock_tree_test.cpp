#include "platform/stm32f405/clock_tree.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/stm32f405_model.hpp"

namespace {

using fog::platform::clock_tree;
using fog::platform::start_clock_tree;
using fog::test::Stm32F405Model;
using fog::test::Stm32Faults;

constexpr std::uint32_t kRccControl = 0x40023800;
constexpr std::uint32_t kFullHz = 168'000'000;
constexpr std::uint32_t kInternalHz = 16'000'000;

// Six waits of 100,000 polls, and what is written in between.
constexpr std::uint64_t kMostAccesses = 700'000;

void expect_consistent(const Stm32F405Model& board) {
  EXPECT_EQ(clock_tree().core_hz, board.core_hz());
  EXPECT_EQ(clock_tree().apb1_hz, board.bus_hz(1));
  EXPECT_EQ(clock_tree().apb2_hz, board.bus_hz(2));
  EXPECT_LT(board.accesses(), kMostAccesses);
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

TEST(ClockTree, RunsAtFullSpeedFromTheCrystalAndWatchesIt) {
  Stm32F405Model board;
  start_clock_tree();
  EXPECT_EQ(clock_tree().core_hz, kFullHz);
  EXPECT_STREQ(clock_tree().source, "crystal");
  EXPECT_FALSE(clock_tree().is_fallback);
  EXPECT_TRUE((board.stored(kRccControl) >> 19U) & 1U) << "clock security system";
  expect_consistent(board);
}

TEST(ClockTree, RunsAtFullSpeedFromTheInternalOscillatorWhereTheCrystalIsDead) {
  Stm32Faults faults;
  faults.crystal_dead = true;
  Stm32F405Model board(faults);
  start_clock_tree();
  EXPECT_EQ(clock_tree().core_hz, kFullHz);
  EXPECT_STREQ(clock_tree().source, "internal oscillator");
  EXPECT_TRUE(clock_tree().is_fallback);
  EXPECT_FALSE((board.stored(kRccControl) >> 16U) & 1U) << "the dead oscillator is off";
  expect_consistent(board);
}

TEST(ClockTree, TriesTheInternalOscillatorWhereThePllDoesNotLockOnTheCrystal) {
  Stm32Faults faults;
  faults.crystal_too_poor_to_lock = true;
  Stm32F405Model board(faults);
  start_clock_tree();
  EXPECT_EQ(clock_tree().core_hz, kFullHz);
  EXPECT_TRUE(clock_tree().is_fallback);
  expect_consistent(board);
}

TEST(ClockTree, StaysAt16MHzWhereThePllNeverLocks) {
  Stm32Faults faults;
  faults.pll_never_locks = true;
  Stm32F405Model board(faults);
  start_clock_tree();
  EXPECT_EQ(clock_tree().core_hz, kInternalHz);
  EXPECT_TRUE(clock_tree().is_fallback);
  expect_consistent(board);
}

// Every combination of five faults: what it says is running is what is, and it always returns.
TEST(ClockTree, SaysWhatIsRunningWhateverFailed) {
  int full_speed = 0;
  for (unsigned combination = 0; combination < 32; ++combination) {
    Stm32Faults faults;
    faults.crystal_dead = (combination & 1U) != 0;
    faults.crystal_too_poor_to_lock = (combination & 2U) != 0;
    faults.pll_never_locks = (combination & 4U) != 0;
    faults.latency_not_taken = (combination & 8U) != 0;
    faults.clock_not_switched = (combination & 16U) != 0;
    SCOPED_TRACE(combination);
    Stm32F405Model board(faults);
    start_clock_tree();
    expect_consistent(board);
    EXPECT_EQ(clock_tree().is_fallback, combination != 0);
    if (clock_tree().core_hz == kFullHz) ++full_speed;
  }
  EXPECT_EQ(full_speed, 4);  // of the 32 those where only the crystal is at fault, or nothing
}

}  // namespace
