#include <gtest/gtest.h>

#include <string>

#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::platform::clock_tree;
using fog::test::Stm32F405Model;
using fog::test::Stm32Start;

TEST(Oscillator, Of25MHzOnTheCrystalsPinMakesFullSpeed) {
  for (const auto start : {Stm32Start::reset, Stm32Start::openocd}) {
    Stm32F405Model board({}, start, 25'000'000);
    board.oscillator = true;
    fog::platform::start_clock_tree();
    EXPECT_EQ(clock_tree().core_hz, 144'000'000U);
    EXPECT_EQ(board.core_hz(), 144'000'000U);
    EXPECT_STREQ(clock_tree().source, "oscillator");
    for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
  }
}

TEST(Oscillator, ThatIsDeadIsFallenBackFrom) {
  fog::test::Stm32Faults faults;
  faults.crystal_dead = true;
  Stm32F405Model board(faults, Stm32Start::reset, 25'000'000);
  board.oscillator = true;
  fog::platform::start_clock_tree();
  EXPECT_TRUE(clock_tree().is_fallback);
  EXPECT_EQ(board.core_hz(), 144'000'000U);
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

}  // namespace
