#pragma once

#include <cstddef>
#include <cstdint>

#include "platform/stm32f405/peripherals.hpp"
#include "platform/stm32f405/pin.hpp"
#include "platform/stm32f405/usart_port.hpp"

namespace fog::platform {

/// Opens a USART, whose clock is enabled, on `pin`, 8N1. `control`: bits of control1 beside the
/// enable bit, i.e. direction and interrupt. `bus_hz`: clock of its bus.
void open_line(Usart& usart, const Pin& pin, std::uint32_t control, std::uint32_t bus_hz,
               std::uint32_t baud);

/// The same, including the clocks.
inline void open_line(const UsartPort& port, const Pin& pin, std::uint32_t control,
                      std::uint32_t baud) {
  enable_clock(port);
  open_line(registers(port), pin, control, bus_hz(port), baud);
}

/// Adds the other direction to an open line: reception on `pin`, with its interrupt.
void open_receiver(Usart& usart, const Pin& pin);

/// Value of the baud rate register, rounded to nearest.
constexpr std::uint32_t baud_divisor(std::uint32_t bus_hz, std::uint32_t baud) {
  return (bus_hz + baud / 2U) / baud;
}

/// Polled: returns when the byte is passed to the USART, or lost because it did not become ready
/// within a millisecond. After that no further byte waits for a stuck USART.
void send_byte(Usart& usart, std::uint8_t byte);

}  // namespace fog::platform
