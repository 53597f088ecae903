#pragma once

#include <cstdint>

#include "platform/shared/bus.hpp"

namespace fog::platform {

/// One 32-bit peripheral register. Each call is exactly one bus access; set and clear are two, so
/// do not use them on registers that an interrupt handler changes.
class Register {
 public:
  std::uint32_t read() const { return bus::read(value_); }
  bool any(std::uint32_t mask) const { return (read() & mask) != 0; }
  void write(std::uint32_t value) { bus::write(value_, value); }
  void set(std::uint32_t mask) { write(read() | mask); }
  void clear(std::uint32_t mask) { write(read() & ~mask); }
  void replace(std::uint32_t mask, std::uint32_t bits) { write((read() & ~mask) | bits); }

 private:
  volatile std::uint32_t value_;
};
static_assert(sizeof(Register) == 4);

/// Registers of a peripheral, laid out by the struct `Block`, at its address.
template <typename Block>
Block& peripheral_at(std::uint32_t address) {
  return *static_cast<Block*>(bus::at(address));
}

/// Polls until `(register & mask) == expected`, at most `polls` times. All waits for hardware use
/// it, so that a peripheral that never answers costs only time.
inline bool wait_for_bits(const Register& reg, std::uint32_t mask, std::uint32_t expected,
                          std::uint32_t polls) {
  while ((reg.read() & mask) != expected) {
    if (polls-- == 0) return false;
  }
  return true;
}

}  // namespace fog::platform
