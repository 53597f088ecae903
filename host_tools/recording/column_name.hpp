#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/unit_spelling.hpp"

namespace fogcomp::recording {

/// Meaning of a CSV column, from its name: a slot as in CsvHeader::slots, or counts of a rate.
struct ColumnMeaning {
  std::size_t slot = 0;
  std::optional<Unit> unit{};  ///< nothing if the name has none
};

/// A column's name in parts: "Gyro_X [deg/s]" is "gyro x" in deg/s.
struct ColumnName {
  /// `from_units_row`: its text in a row of units, if any.
  explicit ColumnName(std::string_view text, std::string_view from_units_row = "");

  std::string text;                ///< as in the file, without quotes
  std::string key;                 ///< folded, without blanks, to compare spellings
  std::string stem_key;            ///< the same without the unit
  std::vector<std::string> words;  ///< folded, without the unit
  std::optional<Unit> unit{};
  std::string unit_text{};     ///< of the unit
  bool unit_alone = false;     ///< "seconds": the unit is all the name
  std::string unknown_unit{};  ///< unit in brackets that is unknown
  /// By which its values are scaled, or divided, as the name says: "rate x1000 [deg/h]".
  std::optional<double> factor{};
  std::string contradiction{};  ///< between name and row of units, if any

  /// Meaning of the name, if it has one. A time, temperature or rate may lack a unit; any other
  /// column must have one.
  std::optional<ColumnMeaning> meaning() const;

  /// Whether it says that its values have the other sign: "-rate_dph", "neg_gyro_z".
  bool has_minus() const;

  /// Whether one of its words begins so.
  bool has_word(const std::vector<std::string_view>& beginnings) const;

 private:
  void take_bracket();
  void take_tail(const std::string& name);
  bool is_part_of_date() const;
  bool is_time() const;
  bool is_no_reading() const;
  bool is_temperature() const;
  bool is_rate() const;
  std::optional<std::size_t> optional_slot() const;
};

/// Folded, without blanks: "Gyro X [°/s]" is "gyrox[deg/s]".
std::string key_of_name(std::string_view name);

/// The factor beside a name: "x1000", "1000*", "1e3", "/10"; of an axis or a sensor's number none.
std::optional<double> factor_in(std::string_view name);

/// A field without enclosing blanks and quotes.
std::string without_quotes(std::string_view field);

/// Quantity of the unit of a recording's column.
Quantity quantity_of(std::size_t slot);

}  // namespace fogcomp::recording
