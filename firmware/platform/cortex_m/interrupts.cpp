#include "hal/interrupts.hpp"

namespace fog::hal {

void hold_interrupts() {
  asm volatile("cpsid i" ::: "memory");
}

void release_interrupts() {
  asm volatile("cpsie i" ::: "memory");
}

}  // namespace fog::hal
