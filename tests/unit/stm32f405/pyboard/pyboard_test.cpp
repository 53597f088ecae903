#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "hal/rate_sink.hpp"
#include "hal/request_source.hpp"
#include "hal/sample_source.hpp"
#include "platform/line_rates.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"

// The drivers of the chip with another board's wiring: another crystal, other serial ports.
namespace {

using fog::test::Stm32F405Model;
using Bytes = std::vector<std::uint8_t>;

constexpr int kOutput = 6, kSensor = 2, kConsole = 3;

void start(Stm32F405Model& board) {
  board.crystal_hz = 12'000'000;
  fog::platform::start_clock_tree();
  fog::platform::open_console_port();
  fog::platform::open_output_port(fog::SerialLine());
  fog::platform::open_request_port();
  fog::platform::open_sensor_port(fog::SerialLine());
}

void expect_no_violations(const Stm32F405Model& board) {
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

TEST(AnotherBoard, RunsAtFullSpeedFromItsOwnCrystal) {
  Stm32F405Model board;
  start(board);
  EXPECT_STREQ(fog::platform::clock_tree().source, "crystal");
  EXPECT_EQ(board.core_hz(), 144'000'000U);
  const auto off = [&](int usart, std::uint32_t baud) {
    return std::abs(double{1} * board.baud(usart) / baud - 1);
  };
  EXPECT_LT(off(kSensor, fog::SerialLine().baud()), 0.025);
  EXPECT_LT(off(kOutput, fog::SerialLine().baud()), 0.025);
  EXPECT_LT(off(kConsole, fog::platform::kConsoleBaud), 0.025);
  expect_no_violations(board);
}

TEST(AnotherBoard, SpeaksOnItsOwnPortsAndNoOther) {
  Stm32F405Model board;
  start(board);
  const Bytes frame{1, 2, 3, 4};
  fog::hal::write_output_stream(frame.data(), frame.size());
  fog::hal::write_console("ready");
  EXPECT_EQ(board.sent(kOutput), frame);
  EXPECT_EQ(board.sent(kConsole), (Bytes{'r', 'e', 'a', 'd', 'y'}));
  EXPECT_TRUE(board.sent(1).empty());
  expect_no_violations(board);
}

TEST(AnotherBoard, HearsItsOwnPorts) {
  Stm32F405Model board;
  start(board);
  std::array<std::uint8_t, 4> received{};
  board.receive(kOutput, 0xA5);
  ASSERT_TRUE(board.interrupt_pending(kOutput));
  fog::platform::on_request_interrupt();
  EXPECT_EQ(fog::hal::read_requests(received.data(), received.size()), 1U);
  EXPECT_EQ(received[0], 0xA5);
  board.receive(kSensor, 0x5A);
  ASSERT_TRUE(board.interrupt_pending(kSensor));
  fog::platform::on_sensor_interrupt();
  EXPECT_EQ(fog::hal::read_sensor_stream(received.data(), received.size()), 1U);
  EXPECT_EQ(received[0], 0x5A);
}

}  // namespace
