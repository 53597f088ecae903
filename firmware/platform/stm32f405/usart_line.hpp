#pragma once

#include <cstddef>
#include <cstdint>

#include "platform/stm32f405/peripherals.hpp"
#include "platform/stm32f405/pin.hpp"
#include "platform/stm32f405/usart_port.hpp"

namespace fog::platform {

/// Opens a USART, whose clock is on, on `pin`, 8N1. `control` is what control1 gets besides the
/// enable bit: the direction and its interrupt. `bus_hz` is the clock of the bus that it is on.
void open_line(Usart& usart, const Pin& pin, std::uint32_t control, std::uint32_t bus_hz,
               std::uint32_t baud);

/// The same with everything that it needs, its clock included.
inline void open_line(const UsartPort& port, const Pin& pin, std::uint32_t control,
                      std::uint32_t baud) {
  enable_clock(port);
  open_line(registers(port), pin, control, bus_hz(port), baud);
}

/// Adds the other direction to an open line: reception on `pin`, with its interrupt.
void open_receiver(Usart& usart, const Pin& pin);

/// The value of the baud rate register: to the nearest.
constexpr std::uint32_t baud_divisor(std::uint32_t bus_hz, std::uint32_t baud) {
  return (bus_hz + baud / 2U) / baud;
}

/// Polled: returns when the byte is handed to the USART, or lost because it did not get ready
/// within a millisecond; of a USART that is stuck the first byte costs that much, those after it
/// nothing.
void send_byte(Usart& usart, std::uint8_t byte);

}  // namespace fog::platform
