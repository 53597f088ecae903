#pragma once

#include <cstddef>
#include <cstdint>

#include "platform/stm32f405/peripherals.hpp"
#include "platform/stm32f405/pins.hpp"

namespace fog::platform {

/// Opens a USART on `pin`, 8N1. `control` is what control1 gets besides the enable bit: the
/// direction and its interrupt. `bus_hz` is the clock of the bus that the USART is on.
void open_line(Usart& usart, const Pin& pin, std::uint32_t control, std::uint32_t bus_hz,
               std::uint32_t baud);

/// Adds the other direction to an open line: reception on `pin`, with its interrupt.
void open_receiver(Usart& usart, const Pin& pin);

/// The value of the baud rate register: to the nearest.
constexpr std::uint32_t baud_divisor(std::uint32_t bus_hz, std::uint32_t baud) {
  return (bus_hz + baud / 2U) / baud;
}

/// Polled: returns when the byte is handed to the USART, or given up because it never gets ready.
void send_byte(Usart& usart, std::uint8_t byte);

}  // namespace fog::platform
