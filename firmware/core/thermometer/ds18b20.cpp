#include "core/thermometer/ds18b20.hpp"

#include "core/bytes/crc.hpp"
#include "core/fixed_point/shift.hpp"
#include "core/signal/span.hpp"

namespace fog {
namespace {

constexpr std::uint8_t kSkipRom = 0xCC;
constexpr std::uint8_t kWriteScratchpad = 0x4E;
constexpr std::uint8_t kConvert = 0x44;
constexpr std::uint8_t kReadScratchpad = 0xBE;

// The alarm registers serve as a mark: neither the factory values (4B 46) nor plausible alarms.
// They are not copied to the sensor's EEPROM, so a power-on resets them.
constexpr std::uint8_t kMarkHigh = 0x5F;
constexpr std::uint8_t kMarkLow = 0xA6;
constexpr std::uint8_t kTwelveBits = 0x7F;

constexpr std::array<std::uint8_t, 5> kConfigureCommand{kSkipRom, kWriteScratchpad, kMarkHigh,
                                                        kMarkLow, kTwelveBits};
constexpr std::array<std::uint8_t, 2> kConvertCommand{kSkipRom, kConvert};
constexpr std::array<std::uint8_t, 2> kReadCommand{kSkipRom, kReadScratchpad};

// A 12-bit conversion takes at most 750 ms; the rest is for the time slots.
constexpr std::uint32_t kLongestConversionMs = 1000;

bool bit_of(Span<const std::uint8_t> bytes, std::size_t bit) {
  return ((bytes.data[bit / 8U] >> (bit % 8U)) & 1U) != 0;
}

}  // namespace

bool decode_scratchpad(const Scratchpad& scratchpad, Temperature& temperature) {
  if (crc8(scratchpad.data(), kScratchpadBytes - 1) != scratchpad[kScratchpadBytes - 1]) {
    return false;
  }
  // A shorted line reads all zeros, which have a good CRC: the mark refuses them as well.
  if (scratchpad[2] != kMarkHigh || scratchpad[3] != kMarkLow || scratchpad[4] != kTwelveBits) {
    return false;
  }
  const auto sixteenths =
      static_cast<std::int16_t>(static_cast<std::uint16_t>(scratchpad[0] | (scratchpad[1] << 8U)));
  temperature = round_to<Temperature>(Fixed<std::int32_t, 4>::from_raw(sixteenths));
  return true;
}

OneWireSlot Ds18b20::next_slot() const {
  if (!present_) return OneWireSlot::reset;
  Span<const std::uint8_t> command{kReadCommand.data(), kReadCommand.size()};
  if (phase_ == Phase::configure) command = {kConfigureCommand.data(), kConfigureCommand.size()};
  if (phase_ == Phase::convert) command = {kConvertCommand.data(), kConvertCommand.size()};
  if (phase_ == Phase::wait || bit_ >= 8U * command.size) return OneWireSlot::read;
  return bit_of(command, bit_) ? OneWireSlot::write_1 : OneWireSlot::write_0;
}

void Ds18b20::slot_made(bool line, std::uint32_t now_ms) {
  latest_.age(now_ms);
  if (!present_) {
    if (line) present_ = true;
    return;  // no sensor: the next reset tries again
  }
  if (phase_ == Phase::wait) return check_ready(line, now_ms);
  constexpr std::size_t kReadCommandBits = 8U * kReadCommand.size();
  if (phase_ == Phase::read && bit_ >= kReadCommandBits) {
    const std::size_t bit = bit_ - kReadCommandBits;
    std::uint8_t& byte = scratchpad_[bit / 8U];
    byte = static_cast<std::uint8_t>((byte >> 1U) | (line ? 0x80U : 0U));
  }
  ++bit_;
  command_sent(now_ms);
}

void Ds18b20::line_failed(std::uint32_t now_ms) {
  latest_.age(now_ms);
  start(Phase::configure);
}

void Ds18b20::start(Phase phase) {
  phase_ = phase;
  present_ = phase == Phase::wait;  // the phase `wait` continues without a reset
  seen_busy_ = false;
  bit_ = 0;
}

// Starts the next phase once all bits of this one have been sent. Not for the phase `wait`.
void Ds18b20::command_sent(std::uint32_t now_ms) {
  if (phase_ == Phase::configure) {
    if (bit_ == 8U * kConfigureCommand.size()) start(Phase::convert);
  } else if (phase_ == Phase::convert) {
    if (bit_ < 8U * kConvertCommand.size()) return;
    start(Phase::wait);
    converting_since_ms_ = now_ms;
  } else if (bit_ == 8U * (kReadCommand.size() + kScratchpadBytes)) {
    scratchpad_read(now_ms);
  }
}

// A sensor that is ready at once has not understood the command: its register has an old value.
void Ds18b20::check_ready(bool ready, std::uint32_t now_ms) {
  if (ready) return start(seen_busy_ ? Phase::read : Phase::configure);
  seen_busy_ = true;
  if (now_ms - converting_since_ms_ > kLongestConversionMs) start(Phase::configure);
}

void Ds18b20::scratchpad_read(std::uint32_t now_ms) {
  TemperatureReading reading;
  reading.valid = decode_scratchpad(scratchpad_, reading.temperature);
  if (!reading.valid) return start(Phase::configure);
  latest_.take(reading, now_ms);
  start(Phase::convert);
}

}  // namespace fog
