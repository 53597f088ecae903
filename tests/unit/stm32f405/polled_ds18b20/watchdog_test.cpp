#include "hal/watchdog.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hal/rate_sink.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
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

// With every wait at its limit, and the watchdog's oscillator at its fastest.
TEST(Watchdog, LeavesTheStartTimeForEveryClockThatDoesNotComeUp) {
  for (unsigned combination = 0; combination < 16; ++combination) {
    Stm32Faults faults;
    faults.crystal_dead = (combination & 1U) != 0;
    faults.crystal_too_poor_to_lock = (combination & 2U) != 0;
    faults.pll_never_locks = (combination & 4U) != 0;
    faults.watchdog_never_updates = (combination & 8U) != 0;
    Stm32F405Model board(faults);
    fog::hal::start_watchdog(fog::hal::kWatchdogStartMs);
    fog::platform::start_clock_tree();
    for (const std::string& violation : board.violations()) {
      ADD_FAILURE() << violation << " " << combination;
    }
  }
}

TEST(Watchdog, IsNotMissedByFramesForATransmitterThatIsStuck) {
  Stm32Faults faults;
  faults.transmitters_stuck = true;
  Stm32F405Model board(faults);
  fog::platform::start_clock_tree();
  fog::platform::open_output_port(fog::SerialLine());
  fog::hal::start_watchdog(fog::hal::kWatchdogLoopMs);
  const std::vector<std::uint8_t> frames(4 * 64);
  for (int loop = 0; loop < 10; ++loop) {
    fog::hal::write_output_stream(frames.data(), frames.size());
    fog::hal::kick_watchdog();
  }
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

TEST(Watchdog, BitesInTheModelWhereNobodyKicksIt) {
  Stm32F405Model board;
  fog::hal::start_watchdog(fog::hal::kWatchdogLoopMs);
  while (board.elapsed_s() < 0.2) board.read(0x40023800);
  EXPECT_EQ(board.violations().count("the watchdog bit"), 1U);
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
