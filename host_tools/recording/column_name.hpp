#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/unit_spelling.hpp"

namespace fogcomp::recording {

/// What a column of a CSV can be, by its name: as CsvHeader::slots, or counts of a rate.
struct ColumnMeaning {
  std::size_t slot = 0;
  std::optional<Unit> unit{};  ///< nothing where the name has none
};

/// A column's name taken apart: "Gyro_X [deg/s]" is "gyro x" in deg/s.
struct ColumnName {
  /// `from_units_row`: what a row of units says of it; "" where there is none.
  explicit ColumnName(std::string_view text, std::string_view from_units_row = "");

  std::string text;                ///< as in the file, without quotes
  std::string key;                 ///< folded, without blanks: what two spellings have in common
  std::string stem_key;            ///< the same without the unit
  std::vector<std::string> words;  ///< folded, without the unit
  std::optional<Unit> unit{};
  std::string unit_text{};      ///< of the unit
  bool unit_alone = false;      ///< "seconds": the unit is all the name
  std::string unknown_unit{};   ///< in brackets, and no unit that is known
  std::string contradiction{};  ///< between name and row of units; "" where there is none

  /// What it means, if it means anything. A time, temperature or rate may come without a unit; any
  /// other column may not.
  std::optional<ColumnMeaning> meaning() const;

 private:
  void take_bracket();
  void take_tail(const std::string& name);
  bool has_word(const std::vector<std::string_view>& beginnings) const;
  bool is_time() const;
  bool is_temperature() const;
  bool is_rate() const;
  std::optional<std::size_t> optional_slot() const;
};

/// Folded, without blanks: "Gyro X [°/s]" is "gyrox[deg/s]".
std::string key_of_name(std::string_view name);

/// A field without blanks and quotes around it.
std::string without_quotes(std::string_view field);

/// Of the unit that a recording has a column in.
Quantity quantity_of(std::size_t slot);

}  // namespace fogcomp::recording
