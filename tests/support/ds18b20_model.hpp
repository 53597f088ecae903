#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/bytes/crc.hpp"

namespace fog::test {

/// A DS18B20 by its data sheet, slot by slot, with its faults as data.
class Ds18b20Model {
 public:
  bool connected = true;
  bool deaf_to_convert = false;       ///< the command is damaged on its way
  bool never_ready = false;           ///< a conversion never ends
  std::size_t flip_bit = kNone;       ///< bit of the scratchpad that is flipped on reading
  std::int16_t sixteenths = 20 * 16;  ///< result of the next conversion
  int busy_slots = 5;                 ///< read slots that a conversion lasts

  Ds18b20Model() { lose_power(); }

  void lose_power() {
    // Maxim 19-7487, table 2: 85 degC, then what the factory put into the EEPROM.
    scratchpad_ = {0x50, 0x05, 0x4B, 0x46, 0x7F, 0xFF, 0x0C, 0x10};
    command_.clear();
    bits_ = 0;
    busy_ = 0;
    reading_ = false;
    finished_ = false;
  }

  /// Returns whether a sensor answers.
  bool reset() {
    command_.clear();
    bits_ = 0;
    reading_ = false;
    finished_ = false;
    return connected;
  }

  void write(bool bit) {
    if (bits_ % 8 == 0) command_.push_back(0);
    command_.back() = static_cast<std::uint8_t>(command_.back() | (bit ? 1U << (bits_ % 8) : 0U));
    if (++bits_ % 8 == 0) obey();
  }

  /// Whether a short low of the master is a read slot, not a 1.
  bool is_talking() const { return connected && (reading_ || busy_ > 0 || finished_); }

  bool read() {
    if (!connected) return true;
    if (reading_) return scratchpad_bit();
    if (busy_ == 0) return true;  // also the bit that signals the end of a conversion
    if (!never_ready && --busy_ == 0) finish_conversion();
    return false;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void obey() {
    if (!connected || command_.size() < 2 || command_[0] != 0xCC) return;
    if (command_[1] == 0x44 && command_.size() == 2 && !deaf_to_convert) busy_ = busy_slots;
    if (command_[1] == 0x4E && command_.size() == 5) {
      for (std::size_t i = 0; i < 3; ++i) scratchpad_[2 + i] = command_[2 + i];
    }
    if (command_[1] == 0xBE) {
      reading_ = true;
      at_ = 0;
    }
  }

  void finish_conversion() {
    finished_ = true;
    scratchpad_[0] = static_cast<std::uint8_t>(sixteenths & 0xFF);
    scratchpad_[1] = static_cast<std::uint8_t>((sixteenths >> 8) & 0xFF);
  }

  bool scratchpad_bit() {
    std::array<std::uint8_t, 9> sent{};
    for (std::size_t i = 0; i < 8; ++i) sent[i] = scratchpad_[i];
    sent[8] = crc8(sent.data(), 8);
    const bool bit = ((sent[at_ / 8 % 9] >> (at_ % 8)) & 1) != 0;
    return bit != (at_++ == flip_bit);
  }

  std::array<std::uint8_t, 8> scratchpad_{};
  std::vector<std::uint8_t> command_;
  std::size_t bits_ = 0;
  int busy_ = 0;
  bool reading_ = false;
  bool finished_ = false;
  std::size_t at_ = 0;
};

}  // namespace fog::test
