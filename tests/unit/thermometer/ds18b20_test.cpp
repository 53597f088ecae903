#include "core/thermometer/ds18b20.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/bytes/crc.hpp"
#include "support/ds18b20_model.hpp"

namespace {

using fog::Ds18b20;
using fog::OneWireSlot;
using fog::test::Ds18b20Model;

// Driver and sensor on one line; a slot takes a tenth of a millisecond.
struct Line {
  Ds18b20 driver;
  Ds18b20Model sensor;
  std::uint32_t slots = 0;
  std::uint32_t start_ms = 0;

  std::uint32_t now_ms() const { return start_ms + slots / 10; }
  fog::TemperatureReading reading() const { return driver.reading(now_ms()); }

  void make_slot() {
    bool line = true;
    switch (driver.next_slot()) {
      case OneWireSlot::none:
        break;
      case OneWireSlot::reset:
        line = sensor.reset();
        break;
      case OneWireSlot::write_0:
      case OneWireSlot::write_1:
        sensor.write(driver.next_slot() == OneWireSlot::write_1);
        break;
      case OneWireSlot::read:
        line = sensor.read();
        break;
    }
    ++slots;
    driver.slot_made(line, now_ms());
  }
  void run(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) make_slot();
  }
};

constexpr std::uint32_t kOneReading = 300;  // slots: with configuration, conversion and repetition
constexpr std::int32_t kDegree = 65536;

TEST(Crc8, HasThePublishedCheckValue) {
  const std::uint8_t text[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(fog::crc8(text, sizeof text), 0xA1);
}

TEST(Ds18b20, ReadsEveryTemperatureOfTheDataSheet) {
  Line line;
  for (const int sixteenths :
       {125 * 16, 85 * 16, 25 * 16 + 1, 10 * 16 + 2, 8, 0, -8, -162, -401, -55 * 16}) {
    line.sensor.sixteenths = static_cast<std::int16_t>(sixteenths);
    line.run(kOneReading);
    EXPECT_TRUE(line.reading().valid) << sixteenths;
    EXPECT_EQ(line.reading().temperature.raw(), sixteenths * (kDegree / 16)) << sixteenths;
  }
}

TEST(Ds18b20, Accepts85DegreesThatWereMeasuredAndRefusesThoseOfThePowerOn) {
  Line line;
  line.sensor.deaf_to_convert = true;
  for (int i = 0; i < 20; ++i) {
    line.run(kOneReading);
    EXPECT_FALSE(line.reading().valid) << "no conversion was made: the register says 85 degC";
  }
  line.sensor.deaf_to_convert = false;
  line.sensor.sixteenths = 85 * 16;
  line.run(kOneReading);
  EXPECT_TRUE(line.reading().valid);
  EXPECT_EQ(line.reading().temperature.raw(), 85 * kDegree);
}

// At whatever slot the sensor loses its power for a moment, no reading is ever 85 degC.
TEST(Ds18b20, NeverTakesA85OfALostPowerForATemperature) {
  for (std::uint32_t lost_at = 0; lost_at < 2 * kOneReading; ++lost_at) {
    Line line;
    line.run(lost_at);
    line.sensor.lose_power();
    for (std::uint32_t i = 0; i < 3 * kOneReading; ++i) {
      line.make_slot();
      if (line.reading().valid) {
        ASSERT_EQ(line.reading().temperature.raw(), 20 * kDegree) << lost_at << " " << i;
      }
    }
    ASSERT_TRUE(line.reading().valid) << "back after losing power at slot " << lost_at;
  }
}

TEST(Ds18b20, RefusesAScratchpadWithAnyBitFlipped) {
  for (std::size_t bit = 0; bit < 72; ++bit) {
    Line line;
    line.sensor.flip_bit = bit;
    line.run(3 * kOneReading);
    EXPECT_FALSE(line.reading().valid) << bit;
  }
}

// With a good CRC: a sensor that has lost its configuration, or another one.
TEST(Scratchpad, WithoutOneOfTheMarks_Refused) {
  fog::Scratchpad scratchpad{0x50, 0x05, 0x5F, 0xA6, 0x7F, 0xFF, 0x0C, 0x10};
  const auto decode = [&] {
    scratchpad.back() = fog::crc8(scratchpad.data(), scratchpad.size() - 1);
    fog::Temperature temperature{};
    return fog::decode_scratchpad(scratchpad, temperature);
  };
  EXPECT_TRUE(decode());
  for (const std::size_t mark : {2U, 3U, 4U}) {
    scratchpad[mark] ^= 1U;
    EXPECT_FALSE(decode()) << mark;
    scratchpad[mark] ^= 1U;
  }
}

TEST(Ds18b20, GivesUpAReadingThatIsOldAndComesBack) {
  Line line;
  line.run(kOneReading);
  ASSERT_TRUE(line.reading().valid);
  line.sensor.connected = false;
  line.run(10 * fog::kOldestReadingMs - 2 * kOneReading);
  EXPECT_TRUE(line.reading().valid) << "held while it is young";
  line.run(3 * kOneReading);
  EXPECT_FALSE(line.reading().valid);
  line.sensor.connected = true;
  line.sensor.lose_power();
  line.run(2 * kOneReading);
  EXPECT_TRUE(line.reading().valid);
}

// The clock wraps after 49.7 days: a sensor that died is not back to life for 3 s then.
TEST(Ds18b20, ADeadSensorStaysDeadWhenTheClockComesRound) {
  for (const bool line_works : {true, false}) {
    Line line;
    line.start_ms = 0U - 30U;  // the reading is taken just behind the wrap
    line.run(kOneReading);
    const std::uint32_t alive_ms = line.now_ms();
    ASSERT_TRUE(line.driver.reading(alive_ms).valid);
    for (std::uint32_t later_ms = 0; later_ms < 10'000; ++later_ms) {
      if (line_works) {
        line.driver.slot_made(false, alive_ms + later_ms);
      } else {
        line.driver.line_failed(alive_ms + later_ms);
      }
    }
    for (std::uint32_t round_ms = 0; round_ms < 4000; ++round_ms) {
      ASSERT_FALSE(line.driver.reading(alive_ms - 500 + round_ms).valid) << round_ms;
    }
  }
}

TEST(Ds18b20, AReadingIsGoodForThreeSecondsToTheMillisecond) {
  Line line;
  EXPECT_FALSE(line.driver.reading(0).valid) << "none yet";
  while (!line.reading().valid) line.make_slot();
  const std::uint32_t read_at = line.now_ms();
  EXPECT_TRUE(line.driver.reading(read_at + 3000).valid);
  EXPECT_FALSE(line.driver.reading(read_at + 3001).valid);
}

TEST(Ds18b20, SlotsAreThoseOfTheDataSheet) {
  Line line;
  // Skip ROM, write scratchpad, the mark, 12 bits; skip ROM, convert T; least significant bit
  // first.
  for (const std::vector<int>& command :
       {std::vector{0xCC, 0x4E, 0x5F, 0xA6, 0x7F}, std::vector{0xCC, 0x44}}) {
    EXPECT_EQ(line.driver.next_slot(), OneWireSlot::reset);
    line.make_slot();
    for (const int byte : command) {
      for (int bit = 0; bit < 8; ++bit) {
        const bool one = ((byte >> bit) & 1) != 0;
        EXPECT_EQ(line.driver.next_slot(), one ? OneWireSlot::write_1 : OneWireSlot::write_0);
        line.make_slot();
      }
    }
  }
  EXPECT_EQ(line.driver.next_slot(), OneWireSlot::read) << "until it is ready";
  while (line.driver.next_slot() == OneWireSlot::read) line.make_slot();
  EXPECT_EQ(line.driver.next_slot(), OneWireSlot::reset);
}

TEST(Ds18b20, GivesUpAConversionAfterASecond) {
  Line line;
  line.sensor.never_ready = true;
  while (line.driver.next_slot() != OneWireSlot::read) line.make_slot();
  const std::uint32_t asked_at = line.now_ms();
  while (line.driver.next_slot() == OneWireSlot::read) line.make_slot();
  EXPECT_EQ(line.now_ms() - asked_at, 1001U);
}

TEST(Ds18b20, GivesUpAConversionThatNeverEnds) {
  Line line;
  line.sensor.never_ready = true;
  line.run(100000);
  EXPECT_FALSE(line.reading().valid);
  line.sensor.never_ready = false;
  line.sensor.lose_power();
  line.run(12000);  // the bound of a second, then a reading
  EXPECT_TRUE(line.reading().valid);
}

TEST(Ds18b20, BeginsAnewWhereverTheLineFails) {
  for (std::uint32_t slots = 0; slots < kOneReading; ++slots) {
    Line line;
    line.run(slots);
    line.driver.line_failed(line.now_ms());
    ASSERT_EQ(line.driver.next_slot(), OneWireSlot::reset) << slots;
    line.sensor.sixteenths = 23 * 16;
    line.run(2 * kOneReading);
    ASSERT_TRUE(line.reading().valid) << slots;
    EXPECT_EQ(line.reading().temperature.raw(), 23 * kDegree) << slots;
  }
}

TEST(Ds18b20, RefusesALineThatIsShortOrOpen) {
  for (const bool level : {false, true}) {
    Ds18b20 driver;
    for (std::uint32_t i = 0; i < 100000; ++i) {
      driver.slot_made(level, i / 10);
      ASSERT_FALSE(driver.reading(i / 10).valid) << level;
    }
  }
}

}  // namespace
