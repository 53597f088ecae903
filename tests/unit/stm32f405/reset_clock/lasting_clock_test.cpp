// The clock that measures the length of a reset: it never waits, never returns a wrong time, and
// does nothing that the manual forbids.
#include "hal/lasting_clock.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/stm32f405_model.hpp"

namespace {

using fog::hal::lasting_time;
using fog::hal::LastingTime;
using fog::test::Stm32BackupDomain;
using fog::test::Stm32F405Model;

class LastingClock : public testing::Test {
 protected:
  ~LastingClock() override {
    for (const std::string& violation : board_.violations()) ADD_FAILURE() << violation;
  }
  // Called like on a board: once a second. Returns the seconds until the time was known.
  int run_until_known() {
    for (int s = 0; s < 10; ++s) {
      if (lasting_time().known) return s;
      board_.let_pass_s(1);
    }
    ADD_FAILURE() << "never known";
    return 10;
  }
  // Difference between two readings, with `change` in between.
  template <class Change>
  double ms_over(Change change) {
    board_.let_pass_s(0.001);  // since the last call
    const LastingTime before = lasting_time();
    change();
    const LastingTime after = lasting_time();
    EXPECT_TRUE(before.known && after.known);
    return static_cast<double>(after.ms - before.ms);
  }

  Stm32F405Model board_;
};

TEST_F(LastingClock, IsUnknownUntilItsCrystalRunsAndWaitsForNothing) {
  board_.backup_domain.crystal_start_s = 2;
  const std::uint64_t before = board_.accesses();
  EXPECT_FALSE(lasting_time().known);
  EXPECT_LT(board_.accesses() - before, 20U);
  EXPECT_EQ(run_until_known(), 5) << "crystal, clock, initialisation, setting, time: a call each";
  EXPECT_LT(board_.accesses() - before, 150U);
}

TEST_F(LastingClock, GoesOnWhileTheResetPinIsHeld) {
  run_until_known();
  for (const double held_s : {0.01, 0.5, 3.0, 59.0, 3600.0, 80'000.0}) {
    const double ms = ms_over([&] {
      board_.pull_reset_pin(held_s);
      board_.let_pass_s(0.02);
    });
    EXPECT_NEAR(ms, (held_s + 0.02) * 1000, 4.5) << held_s;
  }
}

TEST_F(LastingClock, NeverSaysLessThanWhatPassed) {
  run_until_known();
  double max_over = 0;
  for (int day = 0; day < 800; ++day) {
    const double over = ms_over([&] { board_.let_pass_s(86'000); }) - 86'000'000.0;
    EXPECT_GT(over, -4.5) << day;
    max_over = over > max_over ? over : max_over;
  }
  EXPECT_NEAR(max_over, 3 * 86'400'000.0, 5) << "February counts as 31 days";
}

TEST_F(LastingClock, IsUnknownForAMomentAfterAResetAndThenWhereItsCrystalIsDead) {
  run_until_known();
  board_.let_pass_s(1);
  EXPECT_TRUE(lasting_time().known);
  EXPECT_FALSE(lasting_time().known) << "not copied anew yet";
  board_.pull_reset_pin(0);
  EXPECT_FALSE(lasting_time().known);
  board_.let_pass_s(0.001);
  EXPECT_TRUE(lasting_time().known);
  board_.backup_domain.has_crystal = false;
  board_.pull_reset_pin(5);
  for (int s = 0; s < 5; ++s) {
    board_.let_pass_s(1);
    EXPECT_FALSE(lasting_time().known);
  }
}

TEST_F(LastingClock, IsNeverKnownWithoutACrystal) {
  board_.backup_domain.has_crystal = false;
  for (int s = 0; s < 20; ++s) {
    EXPECT_FALSE(lasting_time().known);
    board_.let_pass_s(1);
  }
}

// ES0182: a read that should stop the others may not.
TEST_F(LastingClock, IsNotMisreadWhereItGoesOnBetweenTwoReads) {
  run_until_known();
  board_.backup_domain.holds_while_read = false;
  board_.let_pass_s(1);
  int unknown = 0;
  double last_ms = static_cast<double>(lasting_time().ms);
  double last_s = board_.elapsed_s();
  for (int i = 0; i < 600; ++i) {
    // So that a second starts among the accesses of the next call; every 256th step is a second.
    const double to_step = board_.backup_domain.to_next_step_s(board_.elapsed_s());
    board_.let_pass_s(to_step + 255.0 / 256 + (i % 60) * -1e-7);
    const LastingTime now = lasting_time();
    if (!now.known) {
      ++unknown;
      continue;
    }
    EXPECT_NEAR(static_cast<double>(now.ms) - last_ms, (board_.elapsed_s() - last_s) * 1000, 5)
        << i;
    last_ms = static_cast<double>(now.ms);
    last_s = board_.elapsed_s();
  }
  EXPECT_GT(unknown, 10) << "steps fell between its reads";
}

// Set by another program, with a battery at VBAT.
TEST_F(LastingClock, IsSetAnewWhereItCountsAsAnotherProgramWantedIt) {
  const std::uint32_t rtc = Stm32BackupDomain::kRtc;
  run_until_known();
  board_.write(rtc + 0x24, 0xCA);
  board_.write(rtc + 0x24, 0x53);
  board_.write(rtc + 0x0C, 0xFFFFFFFF);
  board_.let_pass_s(0.001);
  board_.write(rtc + 0x10, 0x000000FF);
  board_.write(rtc + 0x10, 0x000000FF);
  board_.write(rtc + 0x08, 0x20);
  board_.write(rtc + 0x0C, 0xFFFFFF7F);
  board_.pull_reset_pin(1);
  EXPECT_FALSE(lasting_time().known);
  run_until_known();
  EXPECT_EQ(board_.read(rtc + 0x10), 0x007F00FFU);
  EXPECT_EQ(board_.read(rtc + 0x08), 0U);
}

TEST(LastingClockModel, SaysNoToWhatTheManualForbids) {
  Stm32F405Model board;
  const std::uint32_t rtc = Stm32BackupDomain::kRtc;
  const auto forbids = [&](const std::string& what, auto act) {
    act();
    EXPECT_EQ(board.violations().count(what), 1U) << what;
  };
  forbids("backup domain written while it is protected", [&] { board.write(0x40023870, 1); });
  forbids("PWR written while its clock is off", [&] { board.write(0x40007000, 1U << 8U); });
  board.write(0x40023840, 1U << 28U);
  board.write(0x40007000, 1U << 8U);
  board.write(0x40023870, 1);
  board.let_pass_s(1);
  board.write(0x40023870, 0x8101);
  forbids("clock of the RTC changed", [&] { board.write(0x40023870, 0x8201); });
  forbids("RTC written while it is protected", [&] { board.write(rtc + 0x0C, 0x80); });
  board.write(rtc + 0x24, 0xCA);
  board.write(rtc + 0x24, 0x53);
  forbids("RTC set outside its initialisation", [&] { board.write(rtc + 0x10, 0xFF); });
  board.write(rtc + 0x0C, 0x80);
  forbids("time read before it was copied", [&] { board.read(rtc); });
}

}  // namespace
