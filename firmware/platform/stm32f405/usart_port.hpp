#pragma once

#include <cstdint>

#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {

enum class Bus : std::uint8_t { kApb1, kApb2 };

/// A USART that a board can select in its wiring.hpp.
struct UsartPort {
  std::uint32_t address;  ///< RM0090, 2.3
  Bus bus;
  std::uint32_t clock_enable;  ///< bit of the bus's enable register
  std::uint32_t interrupt;     ///< RM0090, table 62
  std::uint32_t dma_channel;   ///< of transmission on DMA 2, stream 7 (table 43); 0: not there
};

constexpr UsartPort kUsart1{0x40011000U, Bus::kApb2, 1U << 4U, 37, 4};
constexpr UsartPort kUsart2{0x40004400U, Bus::kApb1, 1U << 17U, 38, 0};
constexpr UsartPort kUsart3{0x40004800U, Bus::kApb1, 1U << 18U, 39, 0};
constexpr UsartPort kUsart6{0x40011400U, Bus::kApb2, 1U << 5U, 71, 5};

inline Usart& registers(const UsartPort& port) {
  return peripheral_at<Usart>(port.address);
}

inline void enable_clock(const UsartPort& port) {
  enable_clock(port.bus == Bus::kApb1 ? rcc().apb1_enable : rcc().apb2_enable, port.clock_enable);
}

/// Clock of the bus from which its bit rate derives.
inline std::uint32_t bus_hz(const UsartPort& port) {
  return port.bus == Bus::kApb1 ? clock_tree().apb1_hz : clock_tree().apb2_hz;
}

}  // namespace fog::platform
