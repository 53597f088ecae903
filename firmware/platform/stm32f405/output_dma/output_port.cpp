#include <array>

#include "core/frames/output_bytes.hpp"
#include "hal/rate_sink.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "wiring.hpp"

// Frames are copied and sent by DMA 2, stream 7 (RM0090, table 43), while the core continues. It
// waits only if frames come faster than the line sends them.
namespace fog {
namespace platform {
namespace {

constexpr std::size_t kStream = 7;
static_assert(kOutputUsart.dma_channel != 0, "DMA 2, stream 7, serves USART 1 and 6 only");

// The flags of streams 4 to 7, of which those of stream 7 (10.5.4).
constexpr std::size_t kHighFlags = 1;
constexpr std::uint32_t kAllFlags = 0x3DU << 22U;

// The frames of one sample, both selected.
[[gnu::section(".dma_buffers")]] std::array<std::uint8_t, kMaxOutputBytes> outgoing;

// Twice the time that the buffer needs. A poll takes at least 5 cycles.
std::uint32_t polls = 0;

DmaStream& stream() {
  return dma2().stream[kStream];
}

// The stream disables itself at the end and on an error. If it does neither, it is stopped, which
// takes a few cycles: the rest of the buffer is lost, the next frames are not.
void wait_until_idle() {
  Register& configuration = stream().configuration;
  if (wait_for_bits(configuration, DmaStream::kEnable, 0, polls)) return;
  configuration.clear(DmaStream::kEnable);
  wait_for_bits(configuration, DmaStream::kEnable, 0, polls);
}

void send(std::size_t size) {
  dma2().clear[kHighFlags].write(kAllFlags);  // with any of them set the stream would not start
  stream().count.write(static_cast<std::uint32_t>(size));
  __atomic_thread_fence(__ATOMIC_RELEASE);  // the bytes are in memory before the DMA reads them
  stream().configuration.write(DmaStream::channel(kOutputUsart.dma_channel) |
                               DmaStream::kIncrementMemory | DmaStream::kMemoryToPeripheral |
                               DmaStream::kEnable);
}

}  // namespace

void open_output_port(SerialLine line) {
  enable_clock(rcc().ahb1_enable, Rcc::kDma2);
  open_line(kOutputUsart, kOutputTx, Usart::kTransmitter, line);
  constexpr std::uint32_t kBytes = kMaxOutputBytes;
  polls = 2U * kBytes * line.bits_per_byte() * (clock_tree().core_hz / line.baud()) / 5U;
  registers(kOutputUsart).control3.set(Usart::kTransmitByDma);
  stream().peripheral_address.write(bus::address_of(&registers(kOutputUsart).data));
  stream().memory_address.write(bus::address_of(outgoing.data()));
}

}  // namespace platform

void hal::write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  while (size > 0) {
    const std::size_t part = size < platform::outgoing.size() ? size : platform::outgoing.size();
    platform::wait_until_idle();
    for (std::size_t i = 0; i < part; ++i) platform::outgoing[i] = bytes[i];
    platform::send(part);
    bytes += part;
    size -= part;
  }
}

}  // namespace fog
