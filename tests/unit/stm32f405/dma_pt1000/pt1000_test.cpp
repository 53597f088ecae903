#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hal/thermometer.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/processor_stand_in.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::test::now_ms;
using fog::test::Stm32F405Model;

constexpr std::uint32_t kSequence3 = 0x40012034;
constexpr std::uint32_t kSampleTime1 = 0x4001200C;
constexpr std::uint32_t kPortCMode = 0x40020800;

struct Board {
  Stm32F405Model model;
  std::uint32_t noise = 1;
  double code = 2048;  // of 0 degC with equal resistors

  Board() {
    model.analog = [this] {
      noise = noise * 1664525U + 1013904223U;
      const double disturbed = code + std::ldexp(noise, -32) * 2 - 0.5;
      return static_cast<std::uint32_t>(disturbed);
    };
    fog::platform::start_clock_tree();
    fog::hal::start_thermometer();
  }

  // The main loop goes round twice a millisecond or more.
  void run_ms(std::uint32_t duration_ms) {
    for (std::uint32_t i = 0; i < duration_ms; ++i) {
      ++now_ms();
      for (int turn = 0; turn < 5; ++turn) fog::hal::advance_thermometer();
    }
  }
};

double degc() {
  return std::ldexp(fog::hal::own_temperature().temperature_q16, -16);
}

TEST(Pt1000, ReadsTheTemperatureOfItsDivider) {
  Board board;
  EXPECT_EQ(board.model.stored(kSequence3) & 31U, 10U) << "channel 10, pin PC0";
  EXPECT_EQ((board.model.stored(kPortCMode) >> 0U) & 3U, 3U) << "analog";
  EXPECT_EQ(board.model.stored(kSampleTime1) & 7U, 7U) << "480 cycles on channel 10";
  // IEC 60751: 723.35, 1000, 1385.06, 1498.32 ohm.
  for (const auto& [ohm, t] :
       {std::pair{723.35, -70.0}, {1000.0, 0.0}, {1385.06, 100.0}, {1498.32, 130.0}}) {
    board.code = 4096 * ohm / (ohm + 1000);
    board.run_ms(2000);
    EXPECT_TRUE(fog::hal::own_temperature().valid);
    EXPECT_NEAR(degc(), t, 0.05) << "one reading of 512 noisy codes";
  }
  for (const std::string& violation : board.model.violations()) ADD_FAILURE() << violation;
}

TEST(Pt1000, BeginsAgainWhereAConversionWasLost) {
  Board board;
  board.model.faults.converter_dead = true;
  board.run_ms(4000);
  EXPECT_FALSE(fog::hal::own_temperature().valid);
  now_ms() -= 4000;
  EXPECT_FALSE(fog::hal::own_temperature().valid) << "when the clock has come round";
  now_ms() += 4000;
  const std::uint64_t before = board.model.accesses();
  board.run_ms(1000);
  EXPECT_LT(board.model.accesses() - before, 10'000U) << "never waits";
  board.model.faults.converter_dead = false;
  board.run_ms(2000);
  EXPECT_TRUE(fog::hal::own_temperature().valid);
  EXPECT_NEAR(degc(), 0, 0.05);
}

TEST(Pt1000, SaysSoWhereTheSensorIsBrokenOrShort) {
  Board board;
  for (const double code : {1.0, 4094.0}) {
    board.code = code;
    board.run_ms(2000);
    EXPECT_FALSE(fog::hal::own_temperature().valid) << code;
  }
}

}  // namespace
