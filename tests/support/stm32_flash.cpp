#include "support/stm32_flash.hpp"

namespace fog::test {
namespace {

constexpr std::uint32_t kKey = 0x04;
constexpr std::uint32_t kStatus = 0x0C;
constexpr std::uint32_t kControl = 0x10;

// 3.8.5: errors.
constexpr std::uint32_t kWriteProtected = 1U << 4U;
constexpr std::uint32_t kWrongWidth = 1U << 6U;
constexpr std::uint32_t kWrongOrder = 1U << 7U;

constexpr double kByteS = 100e-6;

bool bit(std::uint32_t value, unsigned number) {
  return ((value >> number) & 1U) != 0;
}

}  // namespace

// Four of 16 KiB, one of 64, then of 128.
unsigned Stm32Flash::sector_of(std::uint32_t address) {
  const std::uint32_t offset = address - kMemory;
  if (offset < 0x10000) return offset / 0x4000;
  if (offset < 0x20000) return 4;
  return 4 + offset / 0x20000;
}

std::uint8_t Stm32Flash::byte(std::uint32_t address) const {
  const auto found = bytes_.find(address);
  return found == bytes_.end() ? 0xFF : found->second;
}

void Stm32Flash::refuse(std::uint32_t flag, const std::string& what) {
  status_ |= flag;
  violate_(what);
}

std::uint32_t Stm32Flash::read(std::uint32_t offset, double now_s) const {
  if (offset == kStatus) return status_ | (is_busy(now_s) ? 1U << 16U : 0U);
  if (offset == kControl) return control_ | (locked_ ? 1U << 31U : 0U);
  return 0;
}

// 3.6.1: any wrong key, also one too many, locks it until the next reset.
void Stm32Flash::unlock(std::uint32_t key) {
  if (locked_ && !half_unlocked_ && key == 0x45670123U) {
    half_unlocked_ = true;
    return;
  }
  if (!locked_ || !half_unlocked_ || key != 0xCDEF89ABU) {
    violate_("wrong key for the flash");
    locked_for_good_ = true;
  }
  half_unlocked_ = false;
  locked_ = locked_for_good_;
}

void Stm32Flash::write(std::uint32_t offset, std::uint32_t value, double now_s, double supply_v) {
  if (offset == kKey) return unlock(value);
  if (offset == kStatus) {
    status_ &= ~(value & 0xF3U);
    return;
  }
  if (offset != kControl) return;
  if (is_busy(now_s)) return violate_("flash control written while it is busy");
  if (locked_) return violate_("flash control written while it is locked");
  const unsigned width = value >> 8U & 3U;
  if ((width == 1 && supply_v < 2.1) || (width == 2 && supply_v < 2.7) || width == 3) {
    violate_("flash written wider than the supply allows");
  }
  control_ = value & ~(1U << 31U | 1U << 16U);
  locked_ = bit(value, 31);
  if (bit(value, 16)) erase(now_s, supply_v);
}

// Times of the slowest part, by the width: 8, 16, 32 bits.
void Stm32Flash::erase(double now_s, double /*supply_v*/) {
  if (!bit(control_, 1) || bit(control_, 2) || bit(control_, 0)) {
    return refuse(kWrongOrder, "flash started with nothing to do, or with two things");
  }
  if (write_protected) {
    status_ |= kWriteProtected;
    return;
  }
  const unsigned sector = control_ >> 3U & 15U;
  if (in_use.count(sector) != 0) return violate_("a sector erased that is in use");
  const double slowest_s[3][3] = {{0.8, 0.6, 0.5}, {2.4, 1.4, 1.1}, {4, 2.6, 2}};
  const unsigned size = sector < 4 ? 0 : sector == 4 ? 1 : 2;
  busy_until_s_ = now_s + slowest_s[size][control_ >> 8U & 3U];
  never_ready_now_ = never_ready;
  ++erases_;
  for (auto at = bytes_.begin(); at != bytes_.end();) {
    at = sector_of(at->first) == sector ? bytes_.erase(at) : std::next(at);
  }
}

void Stm32Flash::write_byte(std::uint32_t address, std::uint8_t value, double now_s, bool allowed) {
  if (!allowed) return violate_("memory protection: the flash is read-only");
  if (is_busy(now_s)) return violate_("flash written while it is busy");
  if (locked_ || !bit(control_, 0) || bit(control_, 1)) {
    return refuse(kWrongOrder, "flash written without PG");
  }
  if ((control_ >> 8U & 3U) != 0) return refuse(kWrongWidth, "a byte written with another width");
  if (write_protected) {
    status_ |= kWriteProtected;
    return;
  }
  if (in_use.count(sector_of(address)) != 0) return violate_("a sector written that is in use");
  if ((byte(address) & value) != value) violate_("flash written that is not erased");
  bytes_[address] = static_cast<std::uint8_t>(byte(address) & value);
  busy_until_s_ = now_s + kByteS;
  never_ready_now_ = never_ready;
}

}  // namespace fog::test
