#pragma once

#include <cstdint>

#include "platform/shared/bus.hpp"

namespace fog::platform {

/// One 32-bit peripheral register: each call is exactly one bus access (two for set and clear,
/// which are therefore not for registers that an interrupt handler changes as well).
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

/// A peripheral's registers, as the struct `Block` lays them out, at its address.
template <typename Block>
Block& peripheral_at(std::uint32_t address) {
  return *static_cast<Block*>(bus::at(address));
}

/// Polls until `(register & mask) == expected`, at most `polls` times. Every wait on hardware goes
/// through here: a peripheral that never answers costs time, never the board.
inline bool wait_for_bits(const Register& reg, std::uint32_t mask, std::uint32_t expected,
                          std::uint32_t polls) {
  while ((reg.read() & mask) != expected) {
    if (polls-- == 0) return false;
  }
  return true;
}

}  // namespace fog::platform
