#pragma once

#include <cstdint>

#include "platform/shared/registers.hpp"

// The devices of QEMU's virt machine that the bulk image uses (hw/riscv/virt.c).
namespace fog::platform {

/// A 16550 with byte registers; the emulated one needs no set-up.
struct ByteUart {
  volatile std::uint8_t data;
};

/// SiFive's test device: ends or restarts the machine.
struct TestDevice {
  Register command;

  static constexpr std::uint32_t kRestart = 0x7777;
};

inline ByteUart& console_uart() {
  return peripheral_at<ByteUart>(0x10000000U);
}
inline TestDevice& test_device() {
  return peripheral_at<TestDevice>(0x00100000U);
}

}  // namespace fog::platform
