#include "hal/model_memory.hpp"
#include "hal/watchdog.hpp"
#include "platform/cortex_m/memory_protection.hpp"
#include "platform/stm32f405/peripherals.hpp"

// RM0090, 3.6. Bytes are written one at a time, which works at any supply; wider writes need 2.7 V.
// The code runs from the same flash, with its caches disabled: the next instruction waits until the
// flash is done.
namespace fog {
namespace platform {
namespace {

struct Sector {
  std::uint32_t number;
  std::uint32_t address;
};
// linker/stm32f405.ld checks that they are the slots.
constexpr Sector kSectors[] = {{3, 0x0800C000U}, {4, 0x08010000U}};

constexpr std::uint32_t kPolls = 100'000;  // for conditions that the first poll normally meets

// 64 KiB by bytes: 2.4 s at most (data sheet, table 40). The watchdog's clock may be 1.5 times too
// fast.
constexpr std::uint32_t kEraseMs = 6000;

bool is_done() {
  return wait_for_bits(flash().status, Flash::kBusy, 0, kPolls) &&
         !flash().status.any(Flash::kErrors);
}

/// While this object lives the flash can be erased and written. Its caches are emptied at the end,
/// as they may hold old contents.
class Unlocked {
 public:
  explicit Unlocked(const Sector& sector) : memory_(bus::at(sector.address)) {
    flash().access_control.clear(Flash::kCaches);
    wait_for_bits(flash().status, Flash::kBusy, 0, kPolls);
    if (flash().control.any(
            Flash::kLock)) {  // a key written while unlocked would lock it until the next reset
      flash().key.write(Flash::kUnlock1);
      flash().key.write(Flash::kUnlock2);
    }
    flash().status.write(Flash::kErrors);
    allow_writes(memory_, true);
  }
  ~Unlocked() {
    allow_writes(memory_, false);
    flash().control.write(Flash::kLock);
    flash().access_control.set(Flash::kEmptyCaches);
    flash().access_control.clear(Flash::kEmptyCaches);
    flash().access_control.set(Flash::kCaches);
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  const void* memory_;
};

bool write_word(std::uint32_t address, std::uint32_t word) {
  for (std::uint32_t i = 0; i < sizeof word; ++i) {
    bus::write_byte(address + i, static_cast<std::uint8_t>(word >> (8U * i)));
    if (!is_done()) return false;
  }
  return true;
}

}  // namespace
}  // namespace platform

bool hal::erase_model_memory(std::size_t slot) {
  using namespace platform;
  const Sector& sector = kSectors[slot];
  const Unlocked unlocked(sector);
  extend_watchdog(kEraseMs);
  flash().control.write(Flash::kEraseSector | Flash::sector(sector.number));
  flash().control.set(Flash::kStart);
  return is_done();
}

bool hal::program_model_memory(std::size_t slot, std::size_t at, const std::uint32_t* words,
                               std::size_t count) {
  using namespace platform;
  const Sector& sector = kSectors[slot];
  const Unlocked unlocked(sector);
  flash().control.write(Flash::kProgram);
  const auto first = static_cast<std::uint32_t>(at);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!write_word(sector.address + 4U * (first + i), words[i])) return false;
  }
  return true;
}

}  // namespace fog
