#include "hal/thermometer.hpp"
#include "core/thermometer/ds18b20.hpp"
#include "hal/clock.hpp"
#include "platform/stm32f405/pin_modes.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "wiring.hpp"

// A DS18B20 on a USART as half-duplex line: the USART makes the time slots, so interrupts need not
// be disabled. A byte is one slot; the byte received shows the sensor's answer (Maxim, tutorial
// 214).
namespace fog {
namespace platform {
namespace {

// Reset: 5 bits low, 521 us; a sensor answers in the 5 bits after, which are high.
constexpr std::uint32_t kResetBaud = 9'600;
constexpr std::uint8_t kResetByte = 0xF0;

// Other slots: low for a bit, 8.7 us, or for nine, 78 us. A sensor that sends 0 holds the line low
// for 15 us or more, which is the next bit at least.
constexpr std::uint32_t kSlotBaud = 115'200;
constexpr std::uint8_t kShortLow = 0xFF;
constexpr std::uint8_t kLongLow = 0x00;

// The longest slot is a reset, 1 ms. A byte not received by now is lost.
constexpr std::uint32_t kLostAfterMs = 100;

Ds18b20 sensor;
OneWireSlot slot = OneWireSlot::none;  // in progress
std::uint32_t sent_at_ms = 0;

void send(OneWireSlot next, std::uint32_t now_ms) {
  const bool reset = next == OneWireSlot::reset;
  registers(kOneWireUsart)
      .baud_rate.write(baud_divisor(bus_hz(kOneWireUsart), reset ? kResetBaud : kSlotBaud));
  const std::uint8_t low = next == OneWireSlot::write_0 ? kLongLow : kShortLow;
  registers(kOneWireUsart).data.write(reset ? kResetByte : low);
  slot = next;
  sent_at_ms = now_ms;
}

// A line that is held low reads as 0: no sensor either.
bool slot_result(std::uint8_t received) {
  if (slot == OneWireSlot::reset) return received != kResetByte && received != 0;
  return received == kShortLow;
}

}  // namespace
}  // namespace platform

namespace hal {

using namespace platform;

void start_thermometer() {
  make_open_drain(kOneWire);
  connect(kOneWire);
  enable_clock(kOneWireUsart);
  registers(kOneWireUsart).control3.set(Usart::kHalfDuplex);
  registers(kOneWireUsart).control1.write(Usart::kEnable | Usart::kTransmitter | Usart::kReceiver);
}

// The baud rate changes between slots, so the line must be idle before: transmission complete, not
// only a byte received.
void advance_thermometer() {
  const std::uint32_t now_ms = milliseconds();
  if (slot != OneWireSlot::none) {
    constexpr std::uint32_t kThrough = Usart::kReceived | Usart::kTransmitComplete;
    if ((registers(kOneWireUsart).status.read() & kThrough) == kThrough) {
      sensor.slot_made(slot_result(static_cast<std::uint8_t>(registers(kOneWireUsart).data.read())),
                       now_ms);
    } else if (now_ms - sent_at_ms > kLostAfterMs) {
      sensor.line_failed(now_ms);
    } else {
      return;
    }
  }
  send(sensor.next_slot(), now_ms);
}

OwnTemperature own_temperature() {
  const TemperatureReading reading = sensor.reading(milliseconds());
  return {reading.temperature.raw(), reading.valid};
}

}  // namespace hal
}  // namespace fog
