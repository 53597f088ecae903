#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platform/shared/registers.hpp"

// The registers of the STM32F405 that this firmware uses (ST RM0090).
namespace fog::platform {

struct Rcc {
  Register control;
  Register pll_configuration;
  Register configuration;
  std::array<Register, 9> unused_0c;
  Register ahb1_enable;
  std::array<Register, 3> unused_34;
  Register apb1_enable;
  Register apb2_enable;
  std::array<Register, 11> unused_48;
  Register status;

  // control
  static constexpr std::uint32_t kHsiOn = 1U << 0U;
  static constexpr std::uint32_t kHsiReady = 1U << 1U;
  static constexpr std::uint32_t kHseOn = 1U << 16U;
  static constexpr std::uint32_t kHseReady = 1U << 17U;
  static constexpr std::uint32_t kClockSecurityOn = 1U << 19U;
  static constexpr std::uint32_t kPllOn = 1U << 24U;
  static constexpr std::uint32_t kPllReady = 1U << 25U;

  // pll_configuration
  static constexpr std::uint32_t kPllFields = 0x0F437FFFU;
  static constexpr std::uint32_t kPllFromHse = 1U << 22U;
  static constexpr std::uint32_t pll_fields(std::uint32_t m, std::uint32_t n, std::uint32_t p,
                                            std::uint32_t q) {
    return m | (n << 6U) | ((p / 2U - 1U) << 16U) | (q << 24U);
  }

  // configuration
  static constexpr std::uint32_t kSwitch = 3U << 0U;
  static constexpr std::uint32_t kSwitchToHsi = 0U << 0U;
  static constexpr std::uint32_t kSwitchToPll = 2U << 0U;
  static constexpr std::uint32_t kRunning = 3U << 2U;
  static constexpr std::uint32_t kRunningFromPll = 2U << 2U;
  static constexpr std::uint32_t kPrescalers = 0xFCF0U;
  static constexpr std::uint32_t kApb1By4 = 5U << 10U;
  static constexpr std::uint32_t kApb2By2 = 4U << 13U;

  // ahb1_enable, apb1_enable, apb2_enable
  static constexpr std::uint32_t kGpioA = 1U << 0U;
  static constexpr std::uint32_t kGpioB = 1U << 1U;
  static constexpr std::uint32_t kTimer2 = 1U << 0U;
  static constexpr std::uint32_t kUsart2 = 1U << 17U;
  static constexpr std::uint32_t kUsart3 = 1U << 18U;
  static constexpr std::uint32_t kUsart1 = 1U << 4U;

  // status
  static constexpr std::uint32_t kForgetResetCause = 1U << 24U;
  static constexpr std::uint32_t kBrownOutReset = 1U << 25U;
  static constexpr std::uint32_t kPinReset = 1U << 26U;
  static constexpr std::uint32_t kPowerOnReset = 1U << 27U;
  static constexpr std::uint32_t kSoftwareReset = 1U << 28U;
  static constexpr std::uint32_t kWatchdogReset = 1U << 29U;
};
static_assert(offsetof(Rcc, ahb1_enable) == 0x30 && offsetof(Rcc, apb1_enable) == 0x40 &&
              offsetof(Rcc, status) == 0x74);

struct Flash {
  Register access_control;
  std::array<Register, 4> unused_04;
  Register options;

  // access_control
  static constexpr std::uint32_t kLatency = 7U << 0U;
  static constexpr std::uint32_t kPrefetchAndCaches = 7U << 8U;
  // options: 0 resets below 2.7 V, 1 below 2.4 V, 2 below 2.1 V, 3 not at all
  static constexpr std::uint32_t kBrownOutLevel = 3U << 2U;
  static constexpr std::uint32_t kBrownOutOff = 3U << 2U;
};
static_assert(offsetof(Flash, options) == 0x14);

struct Gpio {
  Register mode;
  Register output_type;
  Register output_speed;
  Register pull;
  std::array<Register, 4> unused_10;
  std::array<Register, 2> alternate_function;
};
static_assert(offsetof(Gpio, alternate_function) == 0x20);

struct Usart {
  Register status;
  Register data;
  Register baud_rate;
  Register control1;

  // status
  static constexpr std::uint32_t kReceived = 1U << 5U;
  static constexpr std::uint32_t kTransmitReady = 1U << 7U;
  // control1
  static constexpr std::uint32_t kReceiver = 1U << 2U;
  static constexpr std::uint32_t kTransmitter = 1U << 3U;
  static constexpr std::uint32_t kReceiveInterrupt = 1U << 5U;
  static constexpr std::uint32_t kEnable = 1U << 13U;
};

struct IndependentWatchdog {
  Register key;
  Register prescaler;
  Register reload;
  Register status;

  static constexpr std::uint32_t kStart = 0xCCCC;
  static constexpr std::uint32_t kUnlock = 0x5555;
  static constexpr std::uint32_t kKick = 0xAAAA;
  static constexpr std::uint32_t kUpdating = 3U << 0U;
};

/// TIM2: 32 bits wide.
struct Timer {
  Register control1;
  std::array<Register, 4> unused_04;
  Register event;
  std::array<Register, 3> unused_18;
  Register count;
  Register prescaler;
  Register auto_reload;

  static constexpr std::uint32_t kEnable = 1U << 0U;
  static constexpr std::uint32_t kUpdate = 1U << 0U;
};
static_assert(offsetof(Timer, count) == 0x24);

inline Rcc& rcc() {
  return peripheral_at<Rcc>(0x40023800U);
}
inline Flash& flash() {
  return peripheral_at<Flash>(0x40023C00U);
}
inline Gpio& gpio(std::uint32_t port) {
  return peripheral_at<Gpio>(0x40020000U + 0x400U * port);
}
inline Usart& usart1() {
  return peripheral_at<Usart>(0x40011000U);
}
inline Usart& usart2() {
  return peripheral_at<Usart>(0x40004400U);
}
inline Usart& usart3() {
  return peripheral_at<Usart>(0x40004800U);
}
inline Timer& timer2() {
  return peripheral_at<Timer>(0x40000000U);
}
inline IndependentWatchdog& watchdog() {
  return peripheral_at<IndependentWatchdog>(0x40003000U);
}

constexpr std::size_t kInterruptLines = 82;
constexpr std::uint32_t kUsart2Interrupt = 38;

/// Switches a peripheral's clock on. The read back gives it the two cycles it needs before its
/// first access (ST ES0182, "Delay after an RCC peripheral clock enabling").
inline void enable_clock(Register& enable, std::uint32_t mask) {
  enable.set(mask);
  static_cast<void>(enable.read());
}

}  // namespace fog::platform
