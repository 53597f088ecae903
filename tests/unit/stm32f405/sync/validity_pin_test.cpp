// PB13, the time of validity: low while a sample comes, high from one byte's time after it.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "hal/sample_source.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::test::Stm32F405Model;

constexpr int kSensor = 2;

class ValidityPin : public testing::Test {
 protected:
  ValidityPin() {
    fog::platform::start_clock_tree();
    fog::platform::open_sensor_port(fog::SerialLine());
  }
  ~ValidityPin() override {
    for (const std::string& violation : board_.violations()) ADD_FAILURE() << violation;
    read_all();
  }

  static std::size_t read_all() {
    std::array<std::uint8_t, 2048> bytes;
    return fog::hal::read_sensor_stream(bytes.data(), bytes.size());
  }
  void serve() {
    for (int i = 0; board_.interrupt_pending(kSensor); ++i) {
      ASSERT_LT(i, 10) << "the interrupt never ends";
      fog::platform::on_sensor_interrupt();
    }
  }
  void receive_sample() {
    for (std::uint8_t byte = 0; byte < 16; ++byte) {
      board_.receive(kSensor, byte);
      serve();
      EXPECT_FALSE(is_high()) << "byte " << int{byte};
    }
  }
  bool is_high() const { return board_.is_driven_high('B', 13); }

  Stm32F405Model board_;
};

TEST_F(ValidityPin, Start_IsAnOutputAndLow) {
  EXPECT_EQ(board_.stored(0x40020400) >> 26U & 3U, 1U);
  EXPECT_FALSE(is_high());
  board_.fall_idle(kSensor);
  serve();
  EXPECT_FALSE(is_high()) << "nothing has come";
}

TEST_F(ValidityPin, EachSample_OneEdgeBehindIt) {
  for (int sample = 0; sample < 100; ++sample) {
    receive_sample();
    board_.fall_idle(kSensor);
    EXPECT_FALSE(is_high()) << "before the interrupt";
    serve();
    EXPECT_TRUE(is_high());
    board_.fall_idle(kSensor);
    serve();
    EXPECT_TRUE(is_high());
    EXPECT_EQ(read_all(), 16U) << "nothing but the sample";
  }
}

TEST_F(ValidityPin, InterruptThatComesLate_ByteThenIdle_High) {
  receive_sample();
  board_.receive(kSensor, 16);
  board_.fall_idle(kSensor);
  serve();
  EXPECT_TRUE(is_high());
  EXPECT_EQ(read_all(), 17U);
}

TEST_F(ValidityPin, Overrun_StillFallsAndRises) {
  board_.receive(kSensor, 1);
  board_.receive(kSensor, 2);  // lost
  board_.fall_idle(kSensor);
  serve();
  EXPECT_TRUE(is_high());
  receive_sample();
}

}  // namespace
