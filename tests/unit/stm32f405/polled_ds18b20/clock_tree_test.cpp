#include "platform/stm32f405/clock_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hal/clock.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::platform::clock_tree;
using fog::platform::start_clock_tree;
using fog::test::Stm32F405Model;
using fog::test::Stm32Faults;
using fog::test::Stm32Start;

constexpr std::uint32_t kRccControl = 0x40023800;
constexpr std::uint32_t kFullHz = 144'000'000;
constexpr std::uint32_t kInternalHz = 16'000'000;

// Twice ten waits of 100,000 polls, and what is written in between.
constexpr std::uint64_t kMaxAccesses = 2'100'000;

void expect_consistent(const Stm32F405Model& board) {
  EXPECT_EQ(clock_tree().core_hz, board.core_hz());
  EXPECT_EQ(clock_tree().apb_hz[0], board.bus_hz(1));
  EXPECT_EQ(clock_tree().apb_hz[1], board.bus_hz(2));
  EXPECT_LT(board.accesses(), kMaxAccesses);
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

// States left by OpenOCD's `reset init`, a boot loader or another image.
class FromAnyStart : public testing::TestWithParam<Stm32Start> {};

TEST_P(FromAnyStart, RunsAtFullSpeedAndSaysSo) {
  for (const bool dead : {false, true}) {
    Stm32Faults faults;
    faults.crystal_dead =
        dead && GetParam() != Stm32Start::boot_loader && GetParam() != Stm32Start::crystal;
    Stm32F405Model board(faults, GetParam());
    start_clock_tree();
    EXPECT_EQ(clock_tree().core_hz, kFullHz);
    EXPECT_EQ(clock_tree().is_fallback, faults.crystal_dead);
    expect_consistent(board);
  }
}

TEST_P(FromAnyStart, StaysOnTheInternalOscillatorWhereTheCrystalIsNotToBeTried) {
  Stm32F405Model board({}, GetParam());
  start_clock_tree(false);
  EXPECT_EQ(clock_tree().core_hz, kFullHz);
  EXPECT_TRUE(clock_tree().is_fallback);
  EXPECT_EQ((board.stored(kRccControl) >> 16U) & 0xDU, 0U) << "crystal, bypass, watch are off";
  expect_consistent(board);
}

INSTANTIATE_TEST_SUITE_P(Left, FromAnyStart,
                         testing::Values(Stm32Start::reset, Stm32Start::openocd,
                                         Stm32Start::boot_loader, Stm32Start::crystal));

TEST(ClockTree, NeverRunsFasterThanTheSupplyAllows) {
  for (const double supply_v : {1.8, 2.0, 2.2, 2.35, 2.5, 2.8, 3.6}) {
    SCOPED_TRACE(supply_v);
    Stm32F405Model board;
    board.supply_v = supply_v;
    start_clock_tree();
    EXPECT_EQ(clock_tree().core_hz, kFullHz);
    expect_consistent(board);
  }
}

// 4 % off in a warm room, 8 % in the cold: one of the speeds matches the line.
TEST(ClockTree, TriesOtherSpeedsUntilTheLineIsUnderstood) {
  for (int permille = -80; permille <= 45; permille += 5) {
    Stm32Faults faults;
    faults.crystal_dead = true;
    Stm32F405Model board(faults);
    board.internal_error = permille / 1000.0;
    start_clock_tree();
    const auto off = [&] { return std::abs(board.core_hz() / (1.0 * kFullHz) - 1); };
    int tries = 0;
    while (off() > 0.025 && tries < 32) {
      fog::hal::try_another_speed();
      ++tries;
    }
    if (permille >= -60) {
      EXPECT_LE(off(), 0.025) << permille;
    }
    EXPECT_LE(board.core_hz(), 168'000'000U);
    for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
  }
  Stm32F405Model board;
  start_clock_tree();
  fog::hal::try_another_speed();
  EXPECT_EQ(board.stored(kRccControl) & 0xF8U, 0x80U) << "a crystal is not to blame";
}

TEST(Interrupts, NoneIsLeftEnabledOrPending) {
  Stm32F405Model board({}, Stm32Start::boot_loader);
  EXPECT_FALSE(board.enabled_interrupts().empty());
  fog::platform::disable_all_interrupts();
  EXPECT_TRUE(board.enabled_interrupts().empty());
  EXPECT_TRUE(board.pending_interrupts().empty());
}

TEST(DirectMemoryAccess, BootLoadersTransfers_Start_Stopped) {
  for (const std::uint32_t stream : {0x40026010U, 0x40026410U}) {
    Stm32F405Model board({}, Stm32Start::boot_loader);
    ASSERT_EQ(board.stored(stream) & 1U, 1U);
    start_clock_tree();
    EXPECT_EQ(board.stored(stream) & 1U, 0U);
    EXPECT_EQ(board.stored(0x40023810U), 0U) << "and none is kept in reset";
  }
}

// Every combination of five faults: the reported clocks are the running ones, and it always
// returns.
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
