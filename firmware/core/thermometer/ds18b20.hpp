#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/thermometer/temperature_reading.hpp"

namespace fog {

/// One time slot of a 1-Wire line, as the master makes it; none: the line rests.
enum class OneWireSlot : std::uint8_t { none, reset, write_0, write_1, read };

constexpr std::size_t kScratchpadBytes = 9;
using Scratchpad = std::array<std::uint8_t, kScratchpadBytes>;

/// A DS18B20, alone on its line, at 12 bits (1/16 degC). Says which slot the line is to make next
/// and is told what it showed, so the timing is the board's and everything else is here.
///
/// The sensor's register says 85 degC from its power-on until its first conversion, with a good
/// CRC. So a temperature counts only if a conversion is known to have been made since: the alarm
/// registers, which a power-on sets back, still hold what was written to them; and after the
/// command the sensor was seen to be busy, then ready. (Maxim 19-7487: memory, "Convert T".)
class Ds18b20 {
 public:
  /// What the line is to do next, never `none`. slot_made() or line_failed() must follow.
  OneWireSlot next_slot() const;

  /// What the line showed in the slot of next_slot(). After `reset`: whether a sensor pulled it low
  /// (presence). After `read`: the bit. After the others it does not matter.
  void slot_made(bool line, std::uint32_t now_ms);

  /// The line did not work: begins anew.
  void line_failed(std::uint32_t now_ms);

  TemperatureReading reading(std::uint32_t now_ms) const { return latest_.at(now_ms); }

 private:
  enum class Phase : std::uint8_t { configure, convert, wait, read };

  void start(Phase phase);
  void command_sent(std::uint32_t now_ms);
  void check_ready(bool ready, std::uint32_t now_ms);
  void scratchpad_read(std::uint32_t now_ms);

  Phase phase_ = Phase::configure;
  bool present_ = false;    // the phase's reset has been answered
  bool seen_busy_ = false;  // the sensor obeyed "Convert T"
  std::size_t bit_ = 0;     // of the command, then of the answer
  Scratchpad scratchpad_{};
  std::uint32_t converting_since_ms_ = 0;

  LatestReading latest_;
};

/// Whether the scratchpad is one that was read without error from a sensor that this class has
/// configured and that has not lost power since. Then `temperature` is what it says.
bool decode_scratchpad(const Scratchpad& scratchpad, Temperature& temperature);

}  // namespace fog
