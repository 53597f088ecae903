#include "hal/watchdog.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/stm32f405_model.hpp"

namespace {

using fog::test::Stm32F405Model;
using fog::test::Stm32Faults;

TEST(Watchdog, BitesAfter100MillisecondsOfItsNominalOscillator) {
  Stm32F405Model board;
  fog::hal::start_watchdog(fog::hal::kWatchdogLoopMs);
  EXPECT_TRUE(board.watchdog_runs());
  EXPECT_NEAR(board.watchdog_timeout_s(32'000), 0.1, 1e-9);
  EXPECT_LT(board.watchdog_timeout_s(17'000), 0.2);  // the slowest that the data sheet allows
  EXPECT_EQ(board.watchdog_kicks(), 1U) << "the new period begins at once";
  fog::hal::kick_watchdog();
  EXPECT_EQ(board.watchdog_kicks(), 2U);
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

TEST(Watchdog, HasHalfASecondForTheStart) {
  Stm32F405Model board;
  fog::hal::start_watchdog(fog::hal::kWatchdogStartMs);
  EXPECT_NEAR(board.watchdog_timeout_s(32'000), 0.5, 1e-9);
  fog::hal::start_watchdog(fog::hal::kWatchdogLoopMs);
  EXPECT_NEAR(board.watchdog_timeout_s(32'000), 0.1, 1e-9);
  EXPECT_EQ(board.watchdog_kicks(), 2U);
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

TEST(Watchdog, RunsEvenWhereItsSettingsNeverArrive) {
  Stm32Faults faults;
  faults.watchdog_never_updates = true;
  Stm32F405Model board(faults);
  fog::hal::start_watchdog(fog::hal::kWatchdogLoopMs);
  EXPECT_TRUE(board.watchdog_runs());
  EXPECT_LT(board.accesses(), 150'000U);
}

}  // namespace
