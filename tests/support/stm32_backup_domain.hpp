#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace fog::test {

/// The backup domain of an STM32F405: the 32,768 Hz crystal and the real-time clock, which only a
/// loss of power resets (RM0090, 5.1.2, 7.3.20 and chapter 26, implemented independently of the
/// driver). Forbidden accesses are reported to `violate` and have no effect, as in the part.
class Stm32BackupDomain {
 public:
  explicit Stm32BackupDomain(std::function<void(const std::string&)> tell)
      : violate_(std::move(tell)) {}

  static constexpr std::uint32_t kControl = 0x40023870;  ///< RCC_BDCR
  static constexpr std::uint32_t kRtc = 0x40002800;

  bool has_crystal = true;
  double crystal_start_s = 0.4;
  bool holds_while_read = true;  ///< else as in ES0182: the registers continue between two reads

  bool writable = false;  ///< DBP of PWR_CR

  std::uint32_t read(std::uint32_t address, double now_s);
  void write(std::uint32_t address, std::uint32_t value, double now_s);
  /// Effect of a system reset.
  void system_reset();

  /// Until the next of the 256 steps of a second.
  double to_next_step_s(double now_s) const;

 private:
  bool crystal_ready(double now_s) const;
  bool clock_runs(double now_s) const;
  double counted_s(double now_s) const;
  void copy(double now_s);
  std::uint32_t calendar(std::uint32_t offset, double at_s) const;
  void write_status(std::uint32_t value, double now_s);
  void write_rtc(std::uint32_t offset, std::uint32_t value);

  std::function<void(const std::string&)> violate_;
  std::uint32_t control_ = 0;
  double crystal_on_s_ = 0;
  std::uint32_t rtc_control_ = 0;
  std::uint32_t prescaler_ = 0x007F00FF;
  bool first_half_written_ = false;
  bool half_unlocked_ = false;
  bool unlocked_ = false;
  bool init_ = false;
  double init_at_s_ = 0;
  bool has_year_ = false;
  double started_at_s_ = 0;  // time of the first of January of year 1
  bool synchronised_ = false;
  double copies_from_s_ = 0;  // the next copy sets the flag
  bool held_ = false;
  double copied_s_ = 0;
};

}  // namespace fog::test
