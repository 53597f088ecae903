#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace fog::test {

/// Erasing and writing the flash of an STM32F405 (RM0090, chapter 3, and table 40 of the data
/// sheet, implemented independently of the driver). A forbidden access is reported to `violate`,
/// sets its error flag, and has no effect.
class Stm32Flash {
 public:
  explicit Stm32Flash(std::function<void(const std::string&)> tell) : violate_(std::move(tell)) {}

  static constexpr std::uint32_t kRegisters = 0x40023C00;
  static constexpr std::uint32_t kMemory = 0x08000000;

  bool write_protected = false;        ///< by option bytes
  bool never_ready = false;            ///< an operation does not end
  std::set<unsigned> in_use{0, 1, 2};  ///< sectors with the image and the table that it uses

  /// KEYR, SR, CR; the access control register belongs to the clock model.
  std::uint32_t read(std::uint32_t offset, double now_s) const;
  void write(std::uint32_t offset, std::uint32_t value, double now_s, double supply_v);
  void write_byte(std::uint32_t address, std::uint8_t value, double now_s, bool allowed);

  /// Time at which code that runs from the flash, outside its caches, continues.
  double done_at_s() const { return busy_until_s_; }
  bool locked() const { return locked_; }
  std::uint8_t byte(std::uint32_t address) const;
  void set_byte(std::uint32_t address, std::uint8_t value) { bytes_[address] = value; }
  unsigned erases() const { return erases_; }

 private:
  static unsigned sector_of(std::uint32_t address);
  bool is_busy(double now_s) const { return never_ready_now_ || now_s < busy_until_s_; }
  void refuse(std::uint32_t flag, const std::string& what);
  void unlock(std::uint32_t key);
  void erase(double now_s, double supply_v);

  std::function<void(const std::string&)> violate_;
  bool locked_ = true;
  bool half_unlocked_ = false;
  bool locked_for_good_ = false;
  bool never_ready_now_ = false;
  std::uint32_t status_ = 0;
  std::uint32_t control_ = 0;
  double busy_until_s_ = 0;
  unsigned erases_ = 0;
  std::map<std::uint32_t, std::uint8_t> bytes_;  // bytes that are not erased
};

}  // namespace fog::test
