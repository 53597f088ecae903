#include "hal/sample_source.hpp"

#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/mps2_an386/peripherals.hpp"
#include "platform/ports.hpp"
#include "platform/ring_buffer.hpp"

namespace fog {
namespace platform {
namespace {

RingBuffer<1024> received;

}  // namespace

void open_sensor_port(SerialLine line) {
  sensor_uart().baud_divisor.write(kClockHz / line.baud());
  sensor_uart().control.write(CmsdkUart::kReceiver | CmsdkUart::kReceiveInterrupt);
  enable_interrupt(kSensorInterrupt);
}

// The interrupt is cleared before the byte is read: later it would clear that of the next byte. If
// the buffer is full, the byte stays in the UART and the interrupt is disabled until the reader
// enables it again.
void on_sensor_interrupt() {
  if (received.is_full()) {
    disable_interrupt(kSensorInterrupt);
    return;
  }
  sensor_uart().interrupt.write(CmsdkUart::kReceived);
  received.push(static_cast<std::uint8_t>(sensor_uart().data.read()));
  signal_event();
}

}  // namespace platform

namespace hal {

std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity) {
  const std::size_t count = platform::received.pop(destination, capacity);
  if (count > 0) platform::enable_interrupt(platform::kSensorInterrupt);
  return count;
}

}  // namespace hal
}  // namespace fog
