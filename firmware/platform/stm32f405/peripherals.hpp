#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platform/shared/registers.hpp"

// The registers of the STM32F405 that this firmware uses (ST RM0090; sections at each).
namespace fog::platform {

/// Reset and clock control: 7.3.
/// The buses of slower peripherals: indices of what there is of each.
enum class Bus : std::uint8_t { kApb1, kApb2 };

struct Rcc {
  Register control;
  Register pll_configuration;
  Register configuration;
  Register unused_0c;
  Register ahb1_reset;
  std::array<Register, 7> unused_14;
  Register ahb1_enable;
  std::array<Register, 3> unused_34;
  std::array<Register, 2> apb_enables;
  std::array<Register, 10> unused_48;
  Register backup_domain;
  Register status;

  // control (7.3.1)
  static constexpr std::uint32_t kHsiOn = 1U << 0U;
  static constexpr std::uint32_t kHsiReady = 1U << 1U;
  static constexpr std::uint32_t kHseOn = 1U << 16U;
  static constexpr std::uint32_t kHseReady = 1U << 17U;
  static constexpr std::uint32_t kHseBypass = 1U << 18U;
  static constexpr std::uint32_t kHsiTrim = 31U << 3U;
  static constexpr std::uint32_t hsi_trim(std::uint32_t steps) { return steps << 3U; }
  static constexpr std::uint32_t kClockSecurityOn = 1U << 19U;
  static constexpr std::uint32_t kPllOn = 1U << 24U;
  static constexpr std::uint32_t kPllReady = 1U << 25U;

  // pll_configuration (7.3.2)
  static constexpr std::uint32_t kPllFields = 0x0F437FFFU;
  static constexpr std::uint32_t kPllFromHse = 1U << 22U;
  static constexpr std::uint32_t pll_fields(std::uint32_t m, std::uint32_t n, std::uint32_t p,
                                            std::uint32_t q) {
    return m | (n << 6U) | ((p / 2U - 1U) << 16U) | (q << 24U);
  }

  // configuration (7.3.3)
  static constexpr std::uint32_t kSwitch = 3U << 0U;
  static constexpr std::uint32_t kSwitchToHsi = 0U << 0U;
  static constexpr std::uint32_t kSwitchToPll = 2U << 0U;
  static constexpr std::uint32_t kRunning = 3U << 2U;
  static constexpr std::uint32_t kRunningFromHsi = 0U << 2U;
  static constexpr std::uint32_t kRunningFromPll = 2U << 2U;
  static constexpr std::uint32_t kPrescalers = 0xFCF0U;
  static constexpr std::uint32_t kApb1By4 = 5U << 10U;
  static constexpr std::uint32_t kApb2By2 = 4U << 13U;

  // ahb1_reset (7.3.5): all that reads and writes memory by itself, DMA 1, DMA 2, Ethernet and USB
  static constexpr std::uint32_t kBusMasters = (3U << 21U) | (1U << 25U) | (1U << 29U);

  // ahb1_enable (7.3.10), apb_enables (7.3.13, 7.3.14)
  static constexpr std::uint32_t kGpioA = 1U << 0U;  // and so on, by port
  static constexpr std::uint32_t kDma2 = 1U << 22U;
  static constexpr std::uint32_t kTimer2 = 1U << 0U;
  static constexpr std::uint32_t kPower = 1U << 28U;
  static constexpr std::uint32_t kAdc1 = 1U << 8U;

  // backup_domain (7.3.20): reset only with that domain
  static constexpr std::uint32_t kLseOn = 1U << 0U;
  static constexpr std::uint32_t kLseReady = 1U << 1U;
  static constexpr std::uint32_t kRtcClock = 3U << 8U;  // cannot be changed once set
  static constexpr std::uint32_t kRtcClockIsLse = 1U << 8U;
  static constexpr std::uint32_t kRtcOn = 1U << 15U;

  // status (7.3.21)
  static constexpr std::uint32_t kForgetResetCause = 1U << 24U;
  static constexpr std::uint32_t kBrownOutReset = 1U << 25U;
  static constexpr std::uint32_t kPinReset = 1U << 26U;
  static constexpr std::uint32_t kPowerOnReset = 1U << 27U;
  static constexpr std::uint32_t kSoftwareReset = 1U << 28U;
  static constexpr std::uint32_t kWatchdogReset = 1U << 29U;
};
static_assert(offsetof(Rcc, ahb1_reset) == 0x10 && offsetof(Rcc, ahb1_enable) == 0x30 &&
              offsetof(Rcc, apb_enables) == 0x40 && offsetof(Rcc, backup_domain) == 0x70 &&
              offsetof(Rcc, status) == 0x74);

/// Flash interface: 3.9.
struct Flash {
  Register access_control;
  Register key;
  Register option_key;
  Register status;
  Register control;
  Register options;

  // access_control (3.9.1)
  static constexpr std::uint32_t kLatency = 7U << 0U;
  static constexpr std::uint32_t kCaches = 6U << 8U;
  static constexpr std::uint32_t kEmptyCaches = 6U << 10U;
  // key (3.9.2)
  static constexpr std::uint32_t kUnlock1 = 0x45670123U;
  static constexpr std::uint32_t kUnlock2 = 0xCDEF89ABU;
  // status (3.9.4): errors are cleared by writing 1
  static constexpr std::uint32_t kErrors = 0xF2U;
  static constexpr std::uint32_t kBusy = 1U << 16U;
  // control (3.9.5); width of a write: bytes unless said otherwise
  static constexpr std::uint32_t kProgram = 1U << 0U;
  static constexpr std::uint32_t kEraseSector = 1U << 1U;
  static constexpr std::uint32_t sector(std::uint32_t number) { return number << 3U; }
  static constexpr std::uint32_t kStart = 1U << 16U;
  static constexpr std::uint32_t kLock = 1U << 31U;
  // options (3.9.9): 0 resets below 2.7 V, 1 below 2.4 V, 2 below 2.1 V, 3 not at all
  static constexpr std::uint32_t kBrownOutLevel = 3U << 2U;
  static constexpr std::uint32_t kBrownOutOff = 3U << 2U;
};
static_assert(offsetof(Flash, options) == 0x14);

/// Unique device identifier: 39.1.
struct UniqueNumber {
  std::array<Register, 3> words;
};

/// General-purpose I/O: 8.4.
struct Gpio {
  Register mode;
  Register output_type;
  Register output_speed;
  Register pull;
  Register input;
  Register unused_14;
  Register set_reset;  ///< lower half: pins to set; upper half: to reset (8.4.7)
  Register unused_1c;
  std::array<Register, 2> alternate_function;

  // mode (8.4.1), pull (8.4.4): two bits a pin
  static constexpr std::uint32_t kInput = 0;
  static constexpr std::uint32_t kOutput = 1;
  static constexpr std::uint32_t kAlternateFunction = 2;
  static constexpr std::uint32_t kAnalog = 3;
  static constexpr std::uint32_t kPullUp = 1;
};
static_assert(offsetof(Gpio, set_reset) == 0x18 && offsetof(Gpio, alternate_function) == 0x20);

/// Serial ports: 30.6.
struct Usart {
  Register status;
  Register data;
  Register baud_rate;
  Register control1;
  Register control2;
  Register control3;

  // status (30.6.1): idle is cleared by reading it, then data
  static constexpr std::uint32_t kIdle = 1U << 4U;
  static constexpr std::uint32_t kReceived = 1U << 5U;
  static constexpr std::uint32_t kTransmitComplete = 1U << 6U;
  static constexpr std::uint32_t kTransmitReady = 1U << 7U;
  // control1 (30.6.4)
  static constexpr std::uint32_t kReceiver = 1U << 2U;
  static constexpr std::uint32_t kTransmitter = 1U << 3U;
  static constexpr std::uint32_t kIdleInterrupt = 1U << 4U;
  static constexpr std::uint32_t kReceiveInterrupt = 1U << 5U;
  static constexpr std::uint32_t kOddParity = 1U << 9U;
  static constexpr std::uint32_t kParity = 1U << 10U;
  static constexpr std::uint32_t kNineBits = 1U << 12U;  // the parity bit among them
  static constexpr std::uint32_t kEnable = 1U << 13U;
  // control2 (30.6.5)
  static constexpr std::uint32_t kTwoStopBits = 2U << 12U;
  // control3 (30.6.6)
  static constexpr std::uint32_t kHalfDuplex = 1U << 3U;
  static constexpr std::uint32_t kTransmitByDma = 1U << 7U;
};

/// One stream of a DMA controller: 10.5.5 to 10.5.9.
struct DmaStream {
  Register configuration;
  Register count;
  Register peripheral_address;
  Register memory_address;
  std::array<Register, 2> unused_10;

  // configuration
  static constexpr std::uint32_t kEnable = 1U << 0U;
  static constexpr std::uint32_t kMemoryToPeripheral = 1U << 6U;
  static constexpr std::uint32_t kIncrementMemory = 1U << 10U;
  static constexpr std::uint32_t channel(std::uint32_t number) { return number << 25U; }
};
static_assert(sizeof(DmaStream) == 0x18);

struct Dma {
  std::array<Register, 2> status;
  std::array<Register, 2> clear;  ///< write 1 to clear the flag of status (10.5.3, 10.5.4)
  std::array<DmaStream, 8> stream;
};

/// Analog-to-digital converter: 13.13.
struct Adc {
  Register status;
  Register control1;
  Register control2;
  std::array<Register, 2> sample_time;
  std::array<Register, 6> unused_14;
  std::array<Register, 3> sequence;
  std::array<Register, 5> unused_38;
  Register data;

  // status (13.13.1)
  static constexpr std::uint32_t kEndOfConversion = 1U << 1U;
  // control2 (13.13.3)
  static constexpr std::uint32_t kOn = 1U << 0U;
  static constexpr std::uint32_t kStart = 1U << 30U;
  // sample_time (13.13.4): three bits a channel
  static constexpr std::uint32_t k480Cycles = 7;
};
static_assert(offsetof(Adc, sequence) == 0x2C && offsetof(Adc, data) == 0x4C);

/// Registers common to all converters: 13.13.16.
struct AdcCommon {
  Register control;

  static constexpr std::uint32_t kPrescaler = 3U << 16U;
  static constexpr std::uint32_t kPrescaleBy4 = 1U << 16U;
};

/// Independent watchdog: 21.4.
struct IndependentWatchdog {
  Register key;
  Register prescaler;
  Register reload;
  Register status;

  // key (21.4.1)
  static constexpr std::uint32_t kStart = 0xCCCC;
  static constexpr std::uint32_t kUnlock = 0x5555;
  static constexpr std::uint32_t kKick = 0xAAAA;
  // status (21.4.4)
  static constexpr std::uint32_t kUpdating = 3U << 0U;
};

/// Power controller: 5.4.
struct Power {
  Register control;

  static constexpr std::uint32_t kBackupDomainWritable = 1U << 8U;
};

/// Real-time clock: 26.6. Time and date in BCD.
struct Rtc {
  Register time;
  Register date;
  Register control;
  Register status;
  Register prescaler;
  std::array<Register, 4> unused_14;
  Register key;
  Register subsecond;

  // date (26.6.2)
  static constexpr std::uint32_t kYear1 = 0x00012101U;  // the first of January, a Monday
  // control (26.6.3)
  static constexpr std::uint32_t kBypassShadow = 1U << 5U;
  static constexpr std::uint32_t kTwelveHours = 1U << 6U;
  // status (26.6.4): flags are cleared by writing 0
  static constexpr std::uint32_t kHasYear = 1U << 4U;
  static constexpr std::uint32_t kSynchronised = 1U << 5U;
  static constexpr std::uint32_t kMayBeSet = 1U << 6U;
  static constexpr std::uint32_t kSet = 1U << 7U;
  // prescaler (26.6.5): 128 * 256 of the crystal's 32,768 a second
  static constexpr std::uint32_t kSubsecondsLessOne = 255U;
  static constexpr std::uint32_t kSecondsOfLse = (127U << 16U) | kSubsecondsLessOne;
  // key (26.3.5)
  static constexpr std::uint32_t kUnlock1 = 0xCA;
  static constexpr std::uint32_t kUnlock2 = 0x53;
  static constexpr std::uint32_t kLock = 0xFF;
};
static_assert(offsetof(Rtc, key) == 0x24);

/// TIM2, 32 bits wide: 18.4.
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

// Memory map: 2.3.
inline Rcc& rcc() {
  return peripheral_at<Rcc>(0x40023800U);
}
inline Register& apb_enable(Bus bus) {
  return rcc().apb_enables[static_cast<std::size_t>(bus)];
}
inline Flash& flash() {
  return peripheral_at<Flash>(0x40023C00U);
}
inline UniqueNumber& unique_number() {
  return peripheral_at<UniqueNumber>(0x1FFF7A10U);
}
inline Gpio& gpio(std::uint32_t port) {
  return peripheral_at<Gpio>(0x40020000U + 0x400U * port);
}
inline Dma& dma2() {
  return peripheral_at<Dma>(0x40026400U);
}
inline Adc& adc1() {
  return peripheral_at<Adc>(0x40012000U);
}
inline AdcCommon& adc_common() {
  return peripheral_at<AdcCommon>(0x40012304U);
}
inline Timer& timer2() {
  return peripheral_at<Timer>(0x40000000U);
}
inline Power& power() {
  return peripheral_at<Power>(0x40007000U);
}
inline Rtc& rtc() {
  return peripheral_at<Rtc>(0x40002800U);
}
inline IndependentWatchdog& watchdog() {
  return peripheral_at<IndependentWatchdog>(0x40003000U);
}

constexpr std::size_t kInterruptLines = 82;

/// Enables a peripheral's clock. The read back provides the two cycles needed before its first
/// access (ST ES0182, "Delay after an RCC peripheral clock enabling").
inline void enable_clock(Register& enable, std::uint32_t mask) {
  enable.set(mask);
  static_cast<void>(enable.read());
}

}  // namespace fog::platform
