#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hal/rate_sink.hpp"
#include "hal/sample_source.hpp"
#include "platform/line_rates.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::test::Stm32F405Model;
using fog::test::Stm32Faults;
using Bytes = std::vector<std::uint8_t>;

constexpr int kOutput = 1, kSensor = 2, kConsole = 3;

// The receive ring belongs to the program, not to the board: bytes left by another test are
// removed.
Bytes read_all() {
  Bytes all;
  std::array<std::uint8_t, 64> chunk;
  while (const std::size_t size = fog::hal::read_sensor_stream(chunk.data(), chunk.size())) {
    all.insert(all.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return all;
}

void start(const Stm32F405Model&, fog::SerialLine sensor = {}, fog::SerialLine output = {}) {
  read_all();
  fog::platform::start_clock_tree();
  fog::platform::open_console_port();
  fog::platform::open_output_port(output);
  fog::platform::open_sensor_port(sensor);
}

void serve(Stm32F405Model& board) {
  for (int i = 0; board.interrupt_pending(kSensor); ++i) {
    ASSERT_LT(i, 10) << "the interrupt never ends";
    fog::platform::on_sensor_interrupt();
  }
}

void expect_no_violations(const Stm32F405Model& board) {
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

// A receiver tolerates 4 %, both ends together.
TEST(SerialPorts, HaveTheirBitRatesOnEveryClock) {
  for (unsigned combination = 0; combination < 3; ++combination) {
    Stm32Faults faults;
    faults.crystal_dead = combination >= 1;
    faults.pll_never_locks = combination == 2;
    Stm32F405Model board(faults);
    start(board);
    const auto off = [&](int usart, std::uint32_t baud) {
      return std::abs(double{1} * board.baud(usart) / baud - 1);
    };
    const double max = combination == 2 ? 0.025 : 0.002;  // of 16 MHz nothing better comes
    EXPECT_LT(off(kSensor, fog::SerialLine().baud()), max) << combination;
    EXPECT_LT(off(kOutput, fog::SerialLine().baud()), max) << combination;
    EXPECT_LT(off(kConsole, fog::platform::kConsoleBaud), max) << combination;
    expect_no_violations(board);
  }
}

fog::SerialLine line(std::uint32_t baud, std::uint32_t format = 0) {
  return fog::SerialLine(baud | format << fog::SerialLine::kStopBit);
}

// The rates that README.md names, with what it says of them.
TEST(SerialPorts, RatesOfATable_AtFullSpeed_AsNearAsReadmeSays) {
  const auto off = [](int usart, std::uint32_t baud) {
    Stm32F405Model board;
    start(board, line(usart == kSensor ? baud : 921'600), line(usart == kOutput ? baud : 921'600));
    expect_no_violations(board);
    return double{1} * board.baud(usart) / baud - 1;
  };
  for (const std::uint32_t baud : {9'600U, 19'200U, 38'400U, 57'600U, 115'200U, 230'400U, 460'800U,
                                   576'000U, 614'400U, 921'600U, 1'000'000U, 2'000'000U}) {
    EXPECT_NEAR(off(kSensor, baud), 0, 0.008) << baud;
    EXPECT_NEAR(off(kOutput, baud), 0, 0.003) << baud;
  }
  EXPECT_NEAR(off(kOutput, 1'843'200), 0, 0.003);
  EXPECT_NEAR(off(kOutput, 3'000'000), 0, 0.001);
  EXPECT_NEAR(off(kOutput, 4'000'000), 0, 0.001);
  EXPECT_NEAR(off(kOutput, 4'147'200), 0.0212, 0.0002);
}

TEST(SerialPorts, ParityAndStopBits_OfATable_AreSet) {
  constexpr std::uint32_t kUsart1 = 0x40011000, kUsart2 = 0x40004400;
  constexpr std::uint32_t kControl1 = 0x0C, kControl2 = 0x10;
  // RM0090, 30.6.4 and 30.6.5: M, PCE and PS; STOP.
  const std::uint32_t parity[] = {0, 0x1400, 0x1600};
  for (std::uint32_t format = 0; format < fog::SerialLine::kFormats; ++format) {
    Stm32F405Model board;
    start(board, line(115'200, format), line(230'400, format));
    for (const std::uint32_t usart : {kUsart1, kUsart2}) {
      EXPECT_EQ(board.read(usart + kControl1) & 0x1600U, parity[format / 2]) << format;
      EXPECT_EQ(board.read(usart + kControl2) & 0x3000U, format % 2 == 0 ? 0U : 0x2000U) << format;
    }
    expect_no_violations(board);
  }
}

TEST(SensorPort, DeliversBytesInOrderAndSurvivesAnOverrun) {
  Stm32F405Model board;
  start(board);
  board.receive(kSensor, 1);
  serve(board);
  board.receive(kSensor, 2);
  board.receive(kSensor, 3);  // nobody was in time: lost
  board.receive(kSensor, 4);
  serve(board);
  EXPECT_FALSE(board.interrupt_pending(kSensor)) << "the overrun is cleared";
  board.receive(kSensor, 5);
  serve(board);
  EXPECT_EQ(read_all(), (Bytes{1, 2, 5}));
}

// Interrupts with random delays: bytes may be lost, but those that arrive are in order.
TEST(SensorPort, LosesOnlyWhatNobodyWasInTimeFor) {
  Stm32F405Model board;
  start(board);
  std::mt19937 random(1);
  Bytes expected;
  Bytes got;
  bool waiting = false;
  for (unsigned i = 0; i < 20000; ++i) {
    const auto byte = static_cast<std::uint8_t>(random());
    if (!waiting) expected.push_back(byte);
    board.receive(kSensor, byte);
    waiting = random() % 8 == 0;  // this interrupt comes after the next byte
    if (!waiting) serve(board);
    if (i % 100 == 0) {
      const Bytes part = read_all();
      got.insert(got.end(), part.begin(), part.end());
    }
  }
  serve(board);
  const Bytes part = read_all();
  got.insert(got.end(), part.begin(), part.end());
  EXPECT_EQ(got, expected);
  EXPECT_LT(got.size(), 19000U) << "there were overruns";
}

TEST(SensorPort, ClosesWhileItsBufferIsFullAndOpensAgain) {
  Stm32F405Model board;
  start(board);
  unsigned taken = 0;
  while (taken < 5000) {
    board.receive(kSensor, static_cast<std::uint8_t>(taken));
    serve(board);
    if (board.interrupt_pending(kSensor)) break;
    ++taken;
    if (taken > 1024) break;
  }
  // The 1025th stays in the port, whose interrupt is off.
  EXPECT_EQ(taken, 1025U);
  EXPECT_FALSE(board.interrupt_pending(kSensor));
  const Bytes first = read_all();
  ASSERT_EQ(first.size(), 1024U);
  serve(board);
  EXPECT_EQ(read_all(), Bytes{static_cast<std::uint8_t>(1024)}) << "the byte that waited";
}

TEST(OutputPort, SendsEveryByteInOrder) {
  Stm32F405Model board;
  start(board);
  Bytes frames(1000);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = static_cast<std::uint8_t>(i * 7);
  fog::hal::write_output_stream(frames.data(), frames.size());
  EXPECT_EQ(board.sent(kOutput), frames);
  fog::hal::write_console("ready\r\n");
  EXPECT_EQ(board.sent(kConsole), (Bytes{'r', 'e', 'a', 'd', 'y', '\r', '\n'}));
  expect_no_violations(board);
}

// Data of one pass of the main loop: four samples with both frames. A poll takes 5 to 8 cycles; a
// fifth of the watchdog's shortest time, 68 ms, is left for the rest.
TEST(OutputPort, AStuckTransmitterCostsBytesAndNotTheBoard) {
  for (const bool slow_clock : {false, true}) {
    Stm32Faults faults;
    faults.transmitters_stuck = true;
    faults.pll_never_locks = slow_clock;
    Stm32F405Model board(faults);
    start(board);
    const std::uint64_t before = board.accesses();
    const Bytes frames(4 * 64);
    fog::hal::write_output_stream(frames.data(), frames.size());
    const double longest_s = 8.0 * static_cast<double>(board.accesses() - before) / board.core_hz();
    EXPECT_LT(longest_s, 0.8 * 0.068) << slow_clock;
    EXPECT_TRUE(board.sent(kOutput).empty());
  }
}

TEST(OutputPort, GoesOnWhenTheTransmitterDoes) {
  Stm32F405Model board;
  start(board);
  board.faults.transmitters_stuck = true;
  const Bytes frame{1, 2, 3, 4};
  fog::hal::write_output_stream(frame.data(), frame.size());
  fog::hal::write_console("x");
  board.faults.transmitters_stuck = false;
  fog::hal::write_output_stream(frame.data(), frame.size());
  EXPECT_EQ(board.sent(kOutput), frame);
  fog::hal::write_console("y");
  EXPECT_EQ(board.sent(kConsole), Bytes{'y'});
  expect_no_violations(board);
}

}  // namespace
