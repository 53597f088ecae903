#pragma once

#include <cstdint>

#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {

/// A USART that a board can select in its wiring.hpp.
struct UsartPort {
  std::uint32_t address;  ///< RM0090, 2.3
  Bus bus;
  std::uint8_t clock_bit;    ///< of the bus's enable register
  std::uint8_t interrupt;    ///< RM0090, table 62
  std::uint8_t dma_channel;  ///< of transmission on DMA 2, stream 7 (table 43); 0: not there
};

constexpr UsartPort kUsart1{0x40011000U, Bus::kApb2, 4, 37, 4};
constexpr UsartPort kUsart2{0x40004400U, Bus::kApb1, 17, 38, 0};
constexpr UsartPort kUsart3{0x40004800U, Bus::kApb1, 18, 39, 0};
constexpr UsartPort kUsart6{0x40011400U, Bus::kApb2, 5, 71, 5};

inline Usart& registers(const UsartPort& port) {
  return peripheral_at<Usart>(port.address);
}

inline void enable_clock(const UsartPort& port) {
  enable_clock(apb_enable(port.bus), 1U << port.clock_bit);
}

/// Clock of the bus from which its bit rate derives.
inline std::uint32_t bus_hz(const UsartPort& port) {
  return clock_tree().apb_hz[static_cast<std::size_t>(port.bus)];
}

}  // namespace fog::platform
