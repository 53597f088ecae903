#pragma once

#include <cstdint>

#include "platform/shared/registers.hpp"

// The devices of QEMU's virt machine that the images use (hw/riscv/virt.c).
namespace fog::platform {

/// A 16550, whose registers are bytes; the emulated one needs no bit rate.
struct ByteUart {
  volatile std::uint8_t data;
  volatile std::uint8_t interrupt_enable;
  volatile std::uint8_t interrupt_identity;
  volatile std::uint8_t line_control;
  volatile std::uint8_t modem_control;
  volatile std::uint8_t line_status;

  static constexpr std::uint8_t kReceiveInterrupt = 1;  // of interrupt_enable
  static constexpr std::uint8_t kReceived = 1;          // of line_status
  static constexpr std::uint8_t kTransmitEmpty = 1U << 5U;
};

/// SiFive's test device: ends or restarts the machine.
struct TestDevice {
  Register command;

  static constexpr std::uint32_t kRestart = 0x7777;
};

/// Hart 0's side of the interrupt controller (PLIC).
struct InterruptClaim {
  Register threshold;
  Register claim;
};

constexpr std::uint32_t kUartInterrupt = 10;

inline ByteUart& line_uart() {
  return peripheral_at<ByteUart>(0x10000000U);
}
inline TestDevice& test_device() {
  return peripheral_at<TestDevice>(0x00100000U);
}
inline Register& interrupt_priority(std::uint32_t source) {
  return peripheral_at<Register>(0x0C000000U + 4U * source);
}
inline Register& interrupts_enabled() {
  return peripheral_at<Register>(0x0C002000U);
}
inline InterruptClaim& interrupt_claim() {
  return peripheral_at<InterruptClaim>(0x0C200000U);
}

}  // namespace fog::platform
