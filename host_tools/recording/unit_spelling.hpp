#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp::recording {

enum class Quantity : std::uint8_t {
  time,
  temperature,
  rate,
  field,
  power,
  voltage,
  vibration,
  counts,  ///< of a converter: a rate, with a scale factor
  date,    ///< no unit: the order of day, month and year
  other,   ///< not in a recording
};

/// A unit as written by users, and its conversion to a recording's unit: ours = (theirs - offset) *
/// factor / divisor.
struct Unit {
  Quantity quantity{};
  std::string words{};  ///< for messages: "deg/s"
  double factor = 1;
  double divisor = 1;  ///< so that 5 ms are 0.005 s exactly
  double offset = 0;
  double span = 0;  ///< of a counter, whose upper half is negative; 0: numbers are what they say

  bool is_ours() const { return factor == 1 && divisor == 1 && offset == 0 && span == 0; }
  double convert(double theirs) const {
    if (span > 0 && theirs >= span / 2) theirs -= span;
    return (theirs - offset) * factor / divisor;
  }
  /// " x 3600", " / 1000", " - 273.15": appended to the name of a converted column.
  std::string conversion_words() const;
};

/// Bits of a gyro's converter or register, at least and at most.
constexpr int kMinConverterBits = 8;
constexpr int kMaxConverterBits = 32;

/// The unit that `spelling` denotes, ignoring case: "deg/s", "°/s", "dps", "deg s^-1", "degrees per
/// second"; "-deg/s" for rates of the other sign. Nothing if unknown.
std::optional<Unit> find_unit(std::string_view spelling);

/// The same, or a multiple of a unit: "0.01 deg/s", as one step of a converter is.
std::optional<Unit> find_multiple(std::string_view spelling);

/// The units of that quantity, as messages have them.
std::vector<std::string> units_of(Quantity quantity);

/// Whether it denotes that unit even at the end of a name without brackets ("coil_degc",
/// "gyro_dps"); a single letter does not.
bool is_unambiguous(std::string_view spelling);

/// `text` normalised for comparison: lower case, ° as "deg", µ as "u", without quotes.
std::string folded(std::string_view text);

}  // namespace fogcomp::recording
