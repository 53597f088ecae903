#pragma once

#include <cstdint>

#include "platform/stm32f405/pin.hpp"
#include "platform/stm32f405/usart_port.hpp"

// Olimex STM32-H405.
namespace fog::platform {

constexpr std::uint32_t kCrystalHz = 8'000'000;
constexpr bool kCrystalIsOscillator = false;  ///< true: an external clock drives OSC_IN
constexpr bool kHasClockCrystal = true;       ///< 32,768 Hz at PC14 and PC15: FOG_RESET_CLOCK=lse

constexpr UsartPort kOutputUsart = kUsart1;
constexpr Pin kOutputTx{Port::kA, 9, 7};    ///< output frames to the user
constexpr Pin kRequestRx{Port::kA, 10, 7};  ///< requests from the user

constexpr UsartPort kSensorUsart = kUsart2;
constexpr Pin kSensorRx{Port::kA, 3, 7};  ///< sensor stream from the demodulator

constexpr UsartPort kConsoleUsart = kUsart3;
constexpr Pin kConsoleTx{Port::kB, 10, 7};

constexpr Pin kServiceStrap{Port::kB, 12, 0};  ///< to ground: a model may be loaded

// Only with FOG_SYNC=tov: rises when a sample is whole.
constexpr Pin kTimeOfValidity{Port::kB, 13, 0};

// Only in images built with FOG_TEMPERATURE=ds18b20: 4.7 kOhm to 3.3 V.
constexpr UsartPort kOneWireUsart = kUsart6;
constexpr Pin kOneWire{Port::kC, 6, 8};

// Only with FOG_TEMPERATURE=pt1000: ADC1_IN10, at the tap of 3.3 V - resistor - PT1000 - ground.
constexpr Pin kPlatinum{Port::kC, 0, 0};
constexpr std::uint32_t kPlatinumChannel = 10;
constexpr std::uint32_t kPlatinumOhmAt0Degc = 1000;
constexpr std::uint32_t kPlatinumSeriesOhm = 1000;

}  // namespace fog::platform
