#include "platform/stm32f405/pin_modes.hpp"

#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {
namespace {

Gpio& port_of(const Pin& pin) {
  const auto port = static_cast<std::uint32_t>(pin.port);
  enable_clock(rcc().ahb1_enable, Rcc::kGpioA << port);
  return gpio(port);
}

void set_mode(Gpio& port, const Pin& pin, std::uint32_t mode) {
  port.mode.replace(3U << (2U * pin.number), mode << (2U * pin.number));
}

}  // namespace

void connect(const Pin& pin) {
  Gpio& port = port_of(pin);
  const std::uint32_t number = pin.number;
  const std::uint32_t shift = 4U * (number % 8U);
  port.alternate_function[number / 8U].replace(0xFU << shift,
                                               std::uint32_t{pin.alternate_function} << shift);
  port.pull.replace(3U << (2U * number), Gpio::kPullUp << (2U * number));
  set_mode(port, pin, Gpio::kAlternateFunction);
}

void make_open_drain(const Pin& pin) {
  port_of(pin).output_type.set(1U << pin.number);
}

void connect_input(const Pin& pin) {
  Gpio& port = port_of(pin);
  port.pull.replace(3U << (2U * pin.number), Gpio::kPullUp << (2U * pin.number));
  set_mode(port, pin, Gpio::kInput);
}

bool is_high(const Pin& pin) {
  return gpio(static_cast<std::uint32_t>(pin.port)).input.any(1U << pin.number);
}

void connect_analog(const Pin& pin) {
  set_mode(port_of(pin), pin, Gpio::kAnalog);
}

}  // namespace fog::platform
