#include "hal/sample_source.hpp"

#include "platform/ports.hpp"
#include "platform/ring_buffer.hpp"
#include "platform/rv32/interrupts.hpp"
#include "platform/rv32_virt/peripherals.hpp"

namespace fog {
namespace platform {
namespace {

RingBuffer<1024> received;

void listen(bool on) {
  line_uart().interrupt_enable = on ? ByteUart::kReceiveInterrupt : std::uint8_t{0};
}

// While the buffer is full bytes stay in the UART: the reader listens again.
void take_received() {
  while ((line_uart().line_status & ByteUart::kReceived) != 0) {
    if (received.is_full()) {
      listen(false);
      return;
    }
    received.push(line_uart().data);
  }
}

}  // namespace

// The line is as fast as whoever writes to it.
void open_sensor_port(SerialLine /*line*/) {
  interrupt_priority(kUartInterrupt).write(1);
  interrupts_enabled().write(1U << kUartInterrupt);
  interrupt_claim().threshold.write(0);
  listen(true);
  enable_external_interrupts();
}

void on_external_interrupt() {
  const std::uint32_t source = interrupt_claim().claim.read();
  if (source == kUartInterrupt) take_received();
  interrupt_claim().claim.write(source);
  signal_event();
}

}  // namespace platform

std::size_t hal::read_sensor_stream(std::uint8_t* destination, std::size_t capacity) {
  const std::size_t count = platform::received.pop(destination, capacity);
  if (count > 0) platform::listen(true);
  return count;
}

}  // namespace fog
