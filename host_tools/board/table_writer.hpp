#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "board/board_table.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {

/// The largest fraction in `min`..`max` with which `largest` fits 32 bits.
inline int fraction_within(double largest, int min, int max) {
  int fraction = max;
  while (fraction > min && std::ldexp(largest, fraction) > 2147483646.0) --fraction;
  return fraction;
}

/// Appends words to a table; checks the range of every rounded value.
class TableWriter {
 public:
  explicit TableWriter(BoardTable& table) : table_(table) {}

  /// Describes the next words.
  void note(const std::string& text) { table_.notes.push_back({table_.words.size(), text}); }

  void integer(std::int64_t value, const char* what) {
    if (value < INT32_MIN || value > INT32_MAX) {
      throw InputError("export",
                       format("%s does not fit the board's format; is a unit wrong?", what));
    }
    table_.words.push_back(static_cast<std::int32_t>(value));
  }

  /// round(value * 2^fraction).
  void real(double value, int fraction, const char* what) {
    const double scaled = std::round(std::ldexp(value, fraction));
    if (!(std::abs(scaled) <= 2147483647.0)) {
      throw InputError("export",
                       format("%s = %g does not fit the board's format (at most %g); is a "
                              "unit wrong?",
                              what, value, std::ldexp(1, 31 - fraction)));
    }
    integer(static_cast<std::int64_t>(scaled), what);
  }

  template <class FixedFormat>
  void real(double value, const char* what) {
    real(value, FixedFormat::fractional_bits, what);
  }

  /// Writes `gain` as two words, multiplier / 2^shift with 30 significant bits.
  void gain(double gain, const char* what) {
    const int shift = gain > 0 ? 30 - std::ilogb(gain) : -1;
    if (shift < 0 || shift > 62) {
      throw InputError("export", format("%s = %g is out of range", what, gain));
    }
    const double multiplier = std::round(std::ldexp(gain, shift));
    integer(static_cast<std::int64_t>(std::min(multiplier, 2147483647.0)), what);
    integer(shift, what);
  }

 private:
  BoardTable& table_;
};

}  // namespace fogcomp::board
