#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platform/shared/registers.hpp"

// The peripherals of the MPS2 AN386 image that this firmware uses (Arm DDI 0479, DAI 0400).
namespace fog::platform {

struct CmsdkUart {
  Register data;
  Register state;
  Register control;
  Register interrupt;
  Register baud_divisor;

  // state
  static constexpr std::uint32_t kTransmitFull = 1U << 0U;
  // control
  static constexpr std::uint32_t kTransmitter = 1U << 0U;
  static constexpr std::uint32_t kReceiver = 1U << 1U;
  static constexpr std::uint32_t kReceiveInterrupt = 1U << 3U;
  // interrupt: write 1 to clear
  static constexpr std::uint32_t kReceived = 1U << 1U;
};

struct CmsdkWatchdog {
  Register load;
  Register value;
  Register control;
  Register interrupt_clear;

  static constexpr std::uint32_t kInterrupt = 1U << 0U;
  static constexpr std::uint32_t kReset = 1U << 1U;
};

inline CmsdkUart& output_uart() {
  return peripheral_at<CmsdkUart>(0x40004000U);
}
inline CmsdkUart& sensor_uart() {
  return peripheral_at<CmsdkUart>(0x40005000U);
}
inline CmsdkUart& console_uart() {
  return peripheral_at<CmsdkUart>(0x40006000U);
}
inline CmsdkWatchdog& watchdog() {
  return peripheral_at<CmsdkWatchdog>(0x40008000U);
}

constexpr std::uint32_t kClockHz = 25'000'000;  ///< core and peripherals alike
constexpr std::size_t kInterruptLines = 32;
constexpr std::uint32_t kRequestInterrupt = 0;  ///< UART 0 receive
constexpr std::uint32_t kSensorInterrupt = 2;   ///< UART 1 receive

}  // namespace fog::platform
