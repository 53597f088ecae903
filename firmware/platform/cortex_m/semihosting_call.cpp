#include "platform/shared/semihosting_call.hpp"

namespace fog::platform::semihosting {

std::int32_t semihosting_call(std::uint32_t operation, const std::uint32_t* arguments) {
  register auto r0 asm("r0") = operation;
  register const std::uint32_t* r1 asm("r1") = arguments;
  asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return static_cast<std::int32_t>(r0);
}

}  // namespace fog::platform::semihosting
