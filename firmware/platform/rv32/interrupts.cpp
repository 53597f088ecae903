#include "hal/interrupts.hpp"

#include <cstdint>

namespace fog::hal {
namespace {

constexpr std::uint32_t kMachineInterruptEnable = 8;  // MIE of mstatus

}  // namespace

void hold_interrupts() {
  asm volatile("csrc mstatus, %0" ::"r"(kMachineInterruptEnable) : "memory");
}

void release_interrupts() {
  asm volatile("csrs mstatus, %0" ::"r"(kMachineInterruptEnable) : "memory");
}

}  // namespace fog::hal
