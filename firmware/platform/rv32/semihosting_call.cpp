#include "platform/shared/semihosting_call.hpp"

namespace fog::platform::semihosting {

// The three instructions mark the call; none of them may be compressed, and no page boundary may
// separate them ("RISC-V Semihosting", RISC-V International).
std::int32_t semihosting_call(std::uint32_t operation, const std::uint32_t* arguments) {
  register auto a0 asm("a0") = operation;
  register const std::uint32_t* a1 asm("a1") = arguments;
  asm volatile(
      ".option push\n"
      ".option norvc\n"
      ".balign 16\n"
      "slli zero, zero, 0x1f\n"
      "ebreak\n"
      "srai zero, zero, 7\n"
      ".option pop\n"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return static_cast<std::int32_t>(a0);
}

}  // namespace fog::platform::semihosting
