#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/thermometer/temperature_reading.hpp"

namespace fog {

/// One time slot of the 1-Wire master; none: the line is idle.
enum class OneWireSlot : std::uint8_t { none, reset, write_0, write_1, read };

constexpr std::size_t kScratchpadBytes = 9;
using Scratchpad = std::array<std::uint8_t, kScratchpadBytes>;

/// Driver of a DS18B20, alone on its line, at 12 bits (1/16 degC). It says which slot comes next
/// and takes the state of the line in that slot; the board does the timing.
///
/// From power-on until its first conversion the sensor's register reads 85 degC, with a good CRC.
/// So a temperature counts only if a conversion has certainly been made since: the alarm registers,
/// which a power-on resets, still hold the values written; and after the command the sensor was
/// first busy, then ready. (Maxim 19-7487: memory, "Convert T".)
class Ds18b20 {
 public:
  /// Next slot, never `none`. slot_made() or line_failed() has to follow.
  OneWireSlot next_slot() const;

  /// State of the line in the slot of next_slot(). After `reset`: whether a sensor pulled it low
  /// (presence). After `read`: the bit. After the others it is ignored.
  void slot_made(bool line, std::uint32_t now_ms);

  /// The line did not work: starts again.
  void line_failed(std::uint32_t now_ms);

  TemperatureReading reading(std::uint32_t now_ms) const { return latest_.at(now_ms); }

 private:
  enum class Phase : std::uint8_t { configure, convert, wait, read };

  void start(Phase phase);
  void command_sent(std::uint32_t now_ms);
  void check_ready(bool ready, std::uint32_t now_ms);
  void scratchpad_read(std::uint32_t now_ms);

  Phase phase_ = Phase::configure;
  bool present_ = false;    // a sensor answered the reset of this phase
  bool seen_busy_ = false;  // the sensor obeyed "Convert T"
  std::size_t bit_ = 0;     // of the command, then of the answer
  Scratchpad scratchpad_{};
  std::uint32_t converting_since_ms_ = 0;

  LatestReading latest_;
};

/// Whether the scratchpad was read without error from a sensor that this class has configured and
/// that has not lost power since. If so, sets `temperature`.
bool decode_scratchpad(const Scratchpad& scratchpad, Temperature& temperature);

}  // namespace fog
