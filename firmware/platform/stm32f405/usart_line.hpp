#pragma once

#include <cstddef>
#include <cstdint>

#include "core/frames/serial_line.hpp"
#include "platform/stm32f405/peripherals.hpp"
#include "platform/stm32f405/pin.hpp"
#include "platform/stm32f405/usart_port.hpp"

namespace fog::platform {

/// Opens a USART with its clocks on `pin`. `control`: direction and interrupt, bits of control1.
void open_line(const UsartPort& port, const Pin& pin, std::uint32_t control, SerialLine line);

/// Adds the other direction to an open line: reception on `pin`, with its interrupt.
void open_receiver(Usart& usart, const Pin& pin);

/// Value of the baud rate register, rounded to nearest.
constexpr std::uint32_t baud_divisor(std::uint32_t bus_hz, std::uint32_t baud) {
  return (bus_hz + baud / 2U) / baud;
}

/// Polled: returns when the byte is passed to the USART, or lost because it did not become ready
/// within 5 ms. After that no further byte waits for a stuck USART.
void send_byte(Usart& usart, std::uint8_t byte);

}  // namespace fog::platform
