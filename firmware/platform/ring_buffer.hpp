#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog::platform {

/// Lock-free queue of bytes from one producer (an interrupt handler) to one consumer (the main
/// loop). Each index is written by one side only and counts modulo 2^32, so full and empty differ
/// and all `kCapacity` slots are used. A release store publishes; the acquire load of the other
/// side sees it. `__atomic` builtins, because <atomic> is not always available freestanding; on a
/// Cortex-M they are plain loads and stores with a barrier.
template <std::uint32_t kCapacity>
class RingBuffer {
  static_assert(kCapacity != 0 && (kCapacity & (kCapacity - 1)) == 0, "indices wrap by masking");

 public:
  /// Producer. Returns false, and stores nothing, if full.
  bool push(std::uint8_t byte) {
    if (is_full()) return false;
    bytes_[written_ & (kCapacity - 1)] = byte;
    __atomic_store_n(&written_, written_ + 1, __ATOMIC_RELEASE);
    return true;
  }

  /// Producer. Once false it stays false until the next push.
  bool is_full() const { return written_ - __atomic_load_n(&read_, __ATOMIC_ACQUIRE) == kCapacity; }

  /// Consumer. Moves up to `capacity` of the oldest bytes to `destination`; returns their number.
  std::size_t pop(std::uint8_t* destination, std::size_t capacity) {
    const std::uint32_t available = __atomic_load_n(&written_, __ATOMIC_ACQUIRE) - read_;
    const std::uint32_t count =
        available < capacity ? available : static_cast<std::uint32_t>(capacity);
    for (std::uint32_t i = 0; i < count; ++i) {
      destination[i] = bytes_[(read_ + i) & (kCapacity - 1)];
    }
    __atomic_store_n(&read_, read_ + count, __ATOMIC_RELEASE);
    return count;
  }

 private:
  std::array<std::uint8_t, kCapacity> bytes_{};
  std::uint32_t written_ = 0;
  std::uint32_t read_ = 0;
};

}  // namespace fog::platform
