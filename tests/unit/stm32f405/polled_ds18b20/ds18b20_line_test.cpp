#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hal/thermometer.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/ds18b20_model.hpp"
#include "support/processor_stand_in.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::test::Ds18b20Model;
using fog::test::now_ms;
using fog::test::Stm32F405Model;

constexpr std::int32_t kDegree = 65536;

/// The sensor at the end of the wire, which sees low times, not bits: long is a reset, medium a 0,
/// short a 1 or a read slot.
std::uint8_t answer(Ds18b20Model& sensor, std::uint32_t baud, std::uint8_t sent) {
  const double bit_us = 1e6 / baud;
  int low_bits = 1;  // the start bit
  for (int bit = 0; bit < 8 && (sent >> bit & 1) == 0; ++bit) ++low_bits;
  const double low_us = low_bits * bit_us;
  if (low_us >= 480) {
    // Presence: 15 to 60 us after the release, low for 60 to 240 us; seen in the bits that it
    // covers.
    return sensor.reset() && 5 * bit_us > 60 ? static_cast<std::uint8_t>(sent & 0xE0) : sent;
  }
  if (low_us >= 60 && low_us <= 120) {
    sensor.write(false);
    return sent;
  }
  EXPECT_TRUE(low_us >= 1 && low_us < 15) << low_us;
  if (!sensor.is_talking()) {
    sensor.write(true);
    return sent;
  }
  return sensor.read() ? sent : static_cast<std::uint8_t>(sent & 0xFC);
}

struct Wire {
  Stm32F405Model board;
  Ds18b20Model sensor;

  explicit Wire(bool crystal_dead = false) {
    board.faults.crystal_dead = crystal_dead;
    sensor.busy_slots = 700;  // a slot a millisecond
    board.one_wire = [this](std::uint32_t baud, std::uint8_t sent) {
      return answer(sensor, baud, sent);
    };
    fog::platform::start_clock_tree();
    fog::hal::start_thermometer();
  }

  void run_ms(std::uint32_t duration_ms) {
    for (std::uint32_t i = 0; i < duration_ms; ++i) {
      ++now_ms();
      board.let_pass(100);
      fog::hal::advance_thermometer();
    }
  }
};

// The driver's static state is kept from test to test, as on a board whose sensor changes.
constexpr std::uint32_t kUntilSureMs = 5000;

TEST(OneWireLine, ReadsTheSensorOnEveryClock) {
  for (const bool crystal_dead : {false, true}) {
    Wire wire(crystal_dead);
    for (const int degc : {20, -40, 85, 60}) {
      wire.sensor.sixteenths = static_cast<std::int16_t>(degc * 16);
      wire.run_ms(kUntilSureMs);
      EXPECT_TRUE(fog::hal::own_temperature().valid) << degc;
      EXPECT_EQ(fog::hal::own_temperature().temperature_q16, degc * kDegree);
    }
    for (const std::string& violation : wire.board.violations()) ADD_FAILURE() << violation;
  }
}

TEST(OneWireLine, ReadsMoreThanOnceASecond) {
  Wire wire;
  wire.run_ms(kUntilSureMs);
  for (int second = 0; second < 20; ++second) {
    wire.sensor.sixteenths = static_cast<std::int16_t>(16 * second);
    wire.run_ms(2000);  // a conversion that began before, and one of the new temperature
    EXPECT_EQ(fog::hal::own_temperature().temperature_q16, second * kDegree);
  }
}

TEST(OneWireLine, GivesUpASensorThatIsGoneAndFindsItAgain) {
  Wire wire;
  wire.run_ms(kUntilSureMs);
  EXPECT_TRUE(fog::hal::own_temperature().valid);
  wire.sensor.connected = false;
  wire.run_ms(kUntilSureMs);
  EXPECT_FALSE(fog::hal::own_temperature().valid);
  wire.sensor.connected = true;
  wire.sensor.lose_power();
  wire.run_ms(kUntilSureMs);
  EXPECT_TRUE(fog::hal::own_temperature().valid);
}

TEST(OneWireLine, NeverWaitsForALineThatIsSilentOrShort) {
  Wire wire;
  for (int silent = 0; silent < 2; ++silent) {
    wire.board.one_wire = nullptr;
    if (silent == 0)
      wire.board.one_wire = [](std::uint32_t, std::uint8_t) { return std::uint8_t{0}; };
    wire.run_ms(kUntilSureMs);
    EXPECT_FALSE(fog::hal::own_temperature().valid);
    const std::uint64_t before = wire.board.accesses();
    wire.run_ms(1000);
    EXPECT_LT(wire.board.accesses() - before, 100 * 1000U + 10'000U);
  }
}

}  // namespace
