#pragma once

#include <cstdint>

#include "core/thermometer/platinum.hpp"
#include "core/thermometer/temperature_reading.hpp"

namespace fog {

/// A platinum thermometer on an ADC. It averages many codes, because one 12-bit code is a quarter
/// of a degree and the model needs hundredths. The converter's noise, about one code, makes the
/// mean finer than a code.
class ResistanceThermometer {
 public:
  static constexpr std::uint32_t kCodes = 512;  ///< of one reading

  /// `code_range`: codes of the converter, 4096 for 12 bits. `reference`: see divider_ratio().
  constexpr ResistanceThermometer(std::uint32_t code_range, ResistanceRatio reference)
      : full_scale_(kCodes * code_range), reference_(reference) {}

  /// One conversion's code, less than the code range.
  void add(std::uint32_t code, std::uint32_t now_ms) {
    sum_ += code;
    if (++count_ < kCodes) return;
    const ResistanceRatio ratio = divider_ratio(sum_, full_scale_, reference_);
    // Outside this range the sensor is open or shorted: no temperature.
    const bool valid = ratio > kShort && ratio < kBroken;
    latest_.take({platinum_temperature(ratio), valid}, now_ms);
    sum_ = 0;
    count_ = 0;
  }

  /// No code was read. This or add() must be called as long as readings are wanted.
  void wait(std::uint32_t now_ms) { latest_.age(now_ms); }

  TemperatureReading reading(std::uint32_t now_ms) const { return latest_.at(now_ms); }

 private:
  // 0.65 and 1.65: -88 degC and 171 degC.
  static constexpr auto kShort = ResistanceRatio::from_raw(174483046);
  static constexpr auto kBroken = ResistanceRatio::from_raw(442918502);

  std::uint32_t full_scale_;
  ResistanceRatio reference_;
  std::uint32_t sum_ = 0;
  std::uint32_t count_ = 0;
  LatestReading latest_;
};

}  // namespace fog
