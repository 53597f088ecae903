#pragma once

#include <cstdint>

namespace fog::platform {

enum class Port : std::uint8_t { kA, kB };

struct Pin {
  Port port;
  std::uint8_t number;
  std::uint8_t alternate_function;
};

// The wiring of the board (Olimex STM32-H405). Another board with this part changes this file.
constexpr Pin kOutputTx{Port::kA, 9, 7};    ///< USART1_TX: output frames to the user
constexpr Pin kRequestRx{Port::kA, 10, 7};  ///< USART1_RX: requests from the user
constexpr Pin kSensorRx{Port::kA, 3, 7};    ///< USART2_RX: sensor stream from the demodulator
constexpr Pin kConsoleTx{Port::kB, 10, 7};  ///< USART3_TX: console
constexpr std::uint32_t kCrystalHz = 8'000'000;

}  // namespace fog::platform
