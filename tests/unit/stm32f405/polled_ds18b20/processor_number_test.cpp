#include <gtest/gtest.h>

#include "hal/processor.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::test::Stm32F405Model;

TEST(ProcessorNumber, IsThatOfThePart) {
  Stm32F405Model board;
  board.unique_number = {0x00340051, 0x57355012, 0x2032394D};
  fog::platform::start_clock_tree();
  EXPECT_EQ(fog::hal::processor_number(), board.unique_number);
}

// Reading it there would be a fault.
TEST(ProcessorNumber, IsNotReadInAnEmulator) {
  fog::test::Stm32Faults faults;
  faults.pll_never_locks = true;
  Stm32F405Model board(faults);
  board.unique_number = {1, 2, 3};
  fog::platform::start_clock_tree();
  EXPECT_EQ(fog::hal::processor_number(), fog::hal::ProcessorNumber{});
}

}  // namespace
