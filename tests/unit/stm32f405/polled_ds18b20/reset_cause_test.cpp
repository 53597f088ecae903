#include "platform/stm32f405/reset_cause.hpp"

#include <gtest/gtest.h>

#include "support/stm32f405_model.hpp"

namespace {

using fog::hal::ResetCause;
using fog::platform::take_hardware_reset_cause;
using fog::test::Stm32F405Model;

// RM0090, 7.3.21.
constexpr std::uint32_t kBrownOut = 1U << 25U;
constexpr std::uint32_t kPin = 1U << 26U;
constexpr std::uint32_t kPowerOn = 1U << 27U;
constexpr std::uint32_t kSoftware = 1U << 28U;
constexpr std::uint32_t kIndependentWatchdog = 1U << 29U;

ResetCause cause_of(std::uint32_t flags) {
  Stm32F405Model board;
  board.reset_flags = flags;
  return take_hardware_reset_cause();
}

TEST(ResetCause, IsWhatTheManualSaysOfTheFlags) {
  EXPECT_EQ(cause_of(kPowerOn | kBrownOut | kPin), ResetCause::power_on);
  EXPECT_EQ(cause_of(kBrownOut | kPin), ResetCause::brown_out);
  EXPECT_EQ(cause_of(kPin), ResetCause::reset_pin);
  EXPECT_EQ(cause_of(kSoftware | kPin), ResetCause::software);
  EXPECT_EQ(cause_of(kIndependentWatchdog | kPin), ResetCause::watchdog);
  EXPECT_EQ(cause_of(0), ResetCause::unknown);
}

TEST(ResetCause, IsForgottenOnceTaken) {
  Stm32F405Model board;
  board.reset_flags = kIndependentWatchdog | kPin;
  EXPECT_EQ(take_hardware_reset_cause(), ResetCause::watchdog);
  EXPECT_EQ(board.reset_flags, 0U);
}

}  // namespace
