#pragma once

#include <cstdint>

namespace fog::platform {

enum class Port : std::uint8_t { kA, kB, kC };

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

// Only in images that are built with FOG_TEMPERATURE=ds18b20: USART6_TX, 4.7 kOhm to 3.3 V.
constexpr Pin kOneWire{Port::kC, 6, 8};

// Only with FOG_TEMPERATURE=pt1000: ADC1_IN10 at the middle of 3.3 V - resistor - PT1000 - ground.
constexpr Pin kPlatinum{Port::kC, 0, 0};
constexpr std::uint32_t kPlatinumChannel = 10;
constexpr std::uint32_t kPlatinumOhmAt0Degc = 1000;
constexpr std::uint32_t kPlatinumSeriesOhm = 1000;

}  // namespace fog::platform
