// The alternate functions of pins: not in RM0090, but in the data sheet (DocID022152, table 9,
// "Alternate function mapping"). No emulator checks them.
#include <gtest/gtest.h>

#include <string>

#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"
#include "wiring.hpp"

namespace {

using fog::platform::Pin;
using fog::platform::UsartPort;
using fog::test::Stm32F405Model;

struct Mapping {
  char port;
  unsigned pin;
  unsigned function;
  std::uint32_t usart;  // base address
  bool transmits;
};

constexpr std::uint32_t kUsart1 = 0x40011000, kUsart2 = 0x40004400, kUsart3 = 0x40004800,
                        kUsart6 = 0x40011400;
constexpr Mapping kMappings[] = {
    {'A', 9, 7, kUsart1, true},   {'A', 10, 7, kUsart1, false}, {'B', 6, 7, kUsart1, true},
    {'B', 7, 7, kUsart1, false},  {'A', 2, 7, kUsart2, true},   {'A', 3, 7, kUsart2, false},
    {'D', 5, 7, kUsart2, true},   {'D', 6, 7, kUsart2, false},  {'B', 10, 7, kUsart3, true},
    {'B', 11, 7, kUsart3, false}, {'C', 10, 7, kUsart3, true},  {'C', 11, 7, kUsart3, false},
    {'C', 6, 8, kUsart6, true},   {'C', 7, 8, kUsart6, false},
};

std::string name_of(char port, unsigned pin) {
  return std::string("P") + port + std::to_string(pin);
}

// Configuration of the pin from the registers, or why it is not connected to this USART.
std::string connection(const Stm32F405Model& board, const Pin& pin, std::uint32_t usart,
                       bool transmits) {
  const auto port = static_cast<char>('A' + static_cast<int>(pin.port));
  const std::uint32_t gpio = 0x40020000U + 0x400U * static_cast<std::uint32_t>(pin.port);
  const unsigned number = pin.number;
  const unsigned mode = (board.stored(gpio) >> (2 * number)) & 3U;
  const unsigned function =
      (board.stored(gpio + 0x20U + 4U * (number / 8U)) >> (4 * (number % 8U))) & 15U;
  if (mode != 2) return name_of(port, number) + " is not in alternate function mode";
  for (const Mapping& mapping : kMappings) {
    if (mapping.port == port && mapping.pin == number && mapping.function == function &&
        mapping.usart == usart && mapping.transmits == transmits) {
      return "";
    }
  }
  return name_of(port, number) + " has AF" + std::to_string(function) + ", which is not this USART";
}

TEST(Pins, ReachTheUsartsThatTheDriversOpen) {
  Stm32F405Model board;
  fog::platform::start_clock_tree();
  fog::platform::open_console_port();
  fog::platform::open_output_port(fog::SerialLine());
  fog::platform::open_sensor_port(fog::SerialLine());
  using namespace fog::platform;  // NOLINT: the names of the wiring
  EXPECT_EQ(connection(board, kOutputTx, kOutputUsart.address, true), "");
  EXPECT_EQ(connection(board, kSensorRx, kSensorUsart.address, false), "");
  EXPECT_EQ(connection(board, kConsoleTx, kConsoleUsart.address, true), "");
}

TEST(Pins, OfAnotherFunctionOrUsartAreFound) {
  Stm32F405Model board;
  fog::platform::start_clock_tree();
  fog::platform::open_output_port(fog::SerialLine());
  using namespace fog::platform;  // NOLINT
  EXPECT_NE(connection(board, kOutputTx, kUsart2, true), "");
  EXPECT_NE(connection(board, kOutputTx, kOutputUsart.address, false), "");
  EXPECT_NE(connection(board, kConsoleTx, kConsoleUsart.address, true), "") << "not opened";
  board.write(0x40020000U + 0x24U, 0x50U);  // AF5 at PA9
  EXPECT_NE(connection(board, kOutputTx, kOutputUsart.address, true), "");
}

}  // namespace
